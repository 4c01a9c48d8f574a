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

/// "Another verdict under other readings: ..."
std::string other_readings(const Study& study, Scene scene, Measure measure, ClaimVerdict main) {
  std::string words;
  for (const ClaimVerdict verdict : {ClaimVerdict::holds, ClaimVerdict::does_not_hold, ClaimVerdict::cannot_be_told}) {
    if (verdict == main) continue;
    std::string names;
    for (std::size_t r = 1; r < readings().size(); ++r)
      if (falls(effect(study, r, scene, measure)).verdict == verdict)
        names += (names.empty() ? "" : ", ") + readings()[r].name;
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
  const Part part = falls(found);
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
