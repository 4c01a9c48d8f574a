#include "study/mai2023/claims.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "study/judgement.hpp"

namespace alate::mai2023 {

namespace {

Effect effect(const Study& study, std::size_t reading, Scene scene, Measure measure) {
  const auto found = change(study.trial(reading, scene, kAco), study.trial(reading, scene, kMai), measure);
  const std::string what = fmt::format("{}, from {} to {}", words_of(measure).name, kAco, kMai);
  return measure == kIteration ? plain_effect(what, "iterations", found) : percent_effect(what, found);
}

/// From the least time of the one to that of the other, percent: other work of the machine makes runs longer only.
std::optional<double> change_of_least_time(const Trial& from, const Trial& to) {
  const auto first = summary_of(from, kTime);
  const auto second = summary_of(to, kTime);
  return first && second && first->least > 0 ? std::optional(100 * (second->least / first->least - 1)) : std::nullopt;
}

/// Mean times count only where the least times say the same.
ClaimPart judge(const Study& study, std::size_t reading, Scene scene, Measure measure) {
  ClaimPart part = falls(effect(study, reading, scene, measure));
  if (measure != kTime) return part;
  const auto least = change_of_least_time(study.trial(reading, scene, kAco), study.trial(reading, scene, kMai));
  if (!least) return part;
  part.words += fmt::format(" The least times: {:+.1f} %.", *least);
  const bool contradicts = part.verdict == ClaimVerdict::holds ? *least >= 0 : *least < 0;
  if (contradicts) part.verdict = ClaimVerdict::cannot_be_told;
  return part;
}

/// What both spend their time on.
std::string work(const Study& study, Scene scene) {
  const auto greedy = summary_of(study.trial(scene, kGreedy), kTime);
  const auto moves = [&](const char* method) {
    double sum = 0;
    const Trial& trial = study.trial(scene, method);
    for (const StudyRun& run : trial.runs) sum += static_cast<double>(run.plan.counters.at("expansions"));
    return sum / static_cast<double>(trial.runs.size());
  };
  return fmt::format(
      " Both try about as many moves, {:.0f} and {:.0f}; {:.0f} ms, the time of the greedy walk, go into laying out "
      "the "
      "lattice, which is the same for both.",
      moves(kAco), moves(kMai), greedy ? greedy->mean : 0);
}

/// "Another verdict under other readings: ..."
std::string other_readings(const Study& study, Scene scene, Measure measure, ClaimVerdict main) {
  if (study.readings.front().trials.front().runs.empty()) return " No other reading was tried.";
  std::string words;
  for (const ClaimVerdict verdict : {ClaimVerdict::holds, ClaimVerdict::does_not_hold, ClaimVerdict::cannot_be_told}) {
    if (verdict == main) continue;
    std::string names;
    for (std::size_t r = 1; r < readings().size(); ++r)
      if (judge(study, r, scene, measure).verdict == verdict) names += (names.empty() ? "" : ", ") + readings()[r].name;
    if (names.empty()) continue;
    std::string said = to_string(verdict);
    std::ranges::replace(said, '_', ' ');
    words += fmt::format("{} it {} with: {}", words.empty() ? " Under other readings" : ";", said, names);
  }
  return words.empty() ? " The same under every other reading." : words + ".";
}

/// An early last change may be a colony that is stuck: how soon is it as good as the other one ends?
std::string overtaking(const Study& study, Scene scene) {
  const auto end = summary_of(study.trial(scene, kAco), kFitness);
  if (!end) return "";
  const auto found = reaches(study.trial(scene, kMai), end->mean);
  if (!found) return fmt::format(" {} never gets as low as {} ends.", kMai, kAco);
  return fmt::format(" A late change can be a late gain: {} is as low after iteration {} as {} ends.", kMai, *found,
                     kAco);
}

std::string means(const Study& study, Scene scene, Measure measure) {
  const auto mean = [&](const char* method) {
    const auto summary = summary_of(study.trial(scene, method), measure);
    return summary ? fmt::format("{} {:.{}f}", method, summary->mean, words_of(measure).decimals)
                   : fmt::format("{} has no route", method);
  };
  return fmt::format(" Means: {}, {}.", mean(kAco), mean(kMai));
}

Claim superior(const Study& study, Scene scene, Measure measure) {
  const MeasureWords& words = words_of(measure);
  const Effect found = effect(study, 0, scene, measure);
  const ClaimPart part = judge(study, 0, scene, measure);
  Claim claim{.id = fmt::format("{}-{}", words.id, kSceneNames[scene]),
              .text = fmt::format("{} scene: superior to ACO on {}", kSceneNames[scene],
                                  measure == kIteration ? "the iteration number" : words.id),
              .published = {},
              .ours = found.change ? std::optional(found.change->value) : std::nullopt,
              .unit = found.unit,
              .verdict = part.verdict,
              .why = part.words + means(study, scene, measure),
              .by_case = {}};
  if (measure == kIteration) claim.why += overtaking(study, scene);
  if (measure == kTime) claim.why += work(study, scene);
  claim.why += other_readings(study, scene, measure, part.verdict);
  for (const char* method : {kAco, kMai})
    if (const auto summary = summary_of(study.trial(scene, method), measure))
      claim.by_case.emplace_back(method, summary->mean);
  return claim;
}

Claim complex_scene(const Study& study) {
  Claim claim{.id = "complex",
              .text = "complex scene: superior to ACO on length, fitness, iteration number and time",
              .published = {},
              .ours = {},
              .unit = "",
              .verdict = ClaimVerdict::cannot_be_told,
              .why = "Its terrain is known to the fourth peak only. On our third scene, which is another one:",
              .by_case = {}};
  for (const Measure measure : kMeasures) {
    const auto found = change(study.trial(kOurs, kAco), study.trial(kOurs, kMai), measure);
    const MeasureWords& words = words_of(measure);
    claim.why += fmt::format("{} {} {}", measure == kFitness ? "" : ";", words.id,
                             found ? change_words(*found, words.unit) : "not known");
  }
  claim.why += ".";
  return claim;
}

}  // namespace

std::vector<Claim> claims(const Study& study) {
  std::vector<Claim> all;
  for (const Scene scene : {kSimple, kMedium})
    for (const Measure measure : {kLength, kFitness, kIteration, kTime}) all.push_back(superior(study, scene, measure));
  all.push_back(complex_scene(study));
  return all;
}

}  // namespace alate::mai2023
