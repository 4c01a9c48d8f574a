#include "study/yin2021/claims.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "study/yin2021/judgement.hpp"

namespace alate::yin2021 {

namespace {

/// What one reading says about a claim.
struct Finding {
  std::vector<Part> parts;
  ClaimVerdict verdict = ClaimVerdict::cannot_be_told;
  std::optional<double> ours = {};
  std::vector<std::pair<std::string, double>> by_case = {};
  std::string more = {};  ///< Sentences beyond the parts.
};

using Ask = Finding (*)(const Study&, std::size_t reading);

struct Asked {
  const char* id;
  const char* text;
  std::optional<double> published;
  const char* unit;
  Ask ask;
};

std::optional<double> value_of(const Effect& effect) {
  return effect.change ? std::optional(effect.change->value) : std::nullopt;
}

void note_mean_of_cases(Finding& finding) {
  std::vector<double> values;
  for (const auto& [name, value] : finding.by_case) values.push_back(value);
  finding.ours = mean_of(values);
}

/// Means of both methods over the maps, as `by_case`.
void note_means(Finding& finding, const Pairs& both) {
  if (const auto li = mean_of(both.li)) finding.by_case.emplace_back(kLi, *li);
  if (const auto yin = mean_of(both.yin)) finding.by_case.emplace_back(kYin, *yin);
}

Pairs final_lengths(const Study& study, Size size, std::size_t reading) {
  return pairs(study.compare(size, reading), final_mean(length_of));
}

std::string on_size(Size size, const char* what) { return fmt::format("{} on {}", what, size_name(size)); }

/// Claims that name no map are tried on both sizes, and either may bear them out.
template <class EffectOf>
Finding on_either_size(EffectOf effect_of, double published) {
  Finding finding;
  for (const Size size : {kSmall, kLarge}) {
    const Effect effect = effect_of(size);
    finding.parts.push_back(falls_to(effect, published));
    if (const auto value = value_of(effect)) {
      finding.by_case.emplace_back(size_name(size), *value);
      if (size == kLarge) finding.ours = value;
    }
  }
  finding.verdict = any_of(finding.parts);
  return finding;
}

/// "On 3 of 40 maps of 30x30 ..." for those that reach the published change by themselves.
std::string single_maps(const std::vector<double>& percent, Size size, double published) {
  const auto reached = std::ranges::count_if(percent, [&](double change) { return change <= published; });
  return fmt::format(" By itself {} of {} maps of {} {} it.", reached, percent.size(), size_name(size),
                     reached == 1 ? "reaches" : "reach");
}

Finding length(const Study& study, std::size_t reading) {
  Finding finding = on_either_size(
      [&](Size size) { return percent_effect(on_size(size, "Mean length"), final_lengths(study, size, reading)); },
      kLengthChange_percent);
  finding.more = single_maps(final_lengths(study, kLarge, reading).percent(), kLarge, kLengthChange_percent);
  return finding;
}

Finding variance(const Study& study, std::size_t reading) {
  Finding finding = on_either_size(
      [&](Size size) {
        return Effect{.what = on_size(size, "Variance of the length within a map"),
                      .unit = "%",
                      .change = variance_change(study.compare(size, reading))};
      },
      kVarianceChange_percent);
  const Pairs large = pairs(study.compare(kLarge, reading), final_variance(length_of));
  finding.more = single_maps(large.percent(), kLarge, kVarianceChange_percent);
  return finding;
}

Finding fewer_turns(const Study& study, std::size_t reading) {
  const Pairs turns = pairs(study.compare(kSmall, reading), of_best(turns_of));
  const Effect effect = plain_effect("Turns of the best route", "turns", turns);
  Finding finding{.parts = {falls(effect)}, .ours = value_of(effect)};
  finding.verdict = all_of(finding.parts);
  note_means(finding, turns);
  return finding;
}

Finding more_turns_yet_shorter(const Study& study, std::size_t reading) {
  const Comparison both = study.compare(kLarge, reading);
  const Pairs turns = pairs(both, of_best(turns_of));
  const Effect effect = plain_effect("Turns of the best route", "turns", turns);
  Finding finding{.parts = {rises(effect), falls(percent_effect("Its length", pairs(both, of_best(length_of))))},
                  .ours = value_of(effect)};
  finding.verdict = all_of(finding.parts);
  note_means(finding, turns);
  return finding;
}

Finding equal_lengths(const Study& study, std::size_t reading) {
  const Pairs lengths = final_lengths(study, kSmall, reading);
  const Effect effect = percent_effect("Mean length", lengths);
  Finding finding{.parts = {hardly_changes(effect)}, .ours = value_of(effect)};
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding longer_then_shorter(const Study& study, std::size_t reading) {
  const Effect first =
      percent_effect("Length after the first iteration", pairs(study.compare(kSmall, reading), mean_at(1, length_of)));
  const Effect last = percent_effect("At the end", final_lengths(study, kSmall, reading));
  Finding finding{.parts = {rises(first), falls(last)}, .ours = value_of(first)};
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding heights_settle(const Study& study, Size size, std::size_t reading, double limit) {
  const Pairs steady = pairs(study.compare(size, reading), settled(deviation_of));
  Finding finding{
      .parts = {at_most(fmt::format("Iteration of the last change of F, {}", kYin), mean_interval(steady.yin), limit),
                above(kLi, mean_interval(steady.li), limit)},
      .ours = mean_of(steady.yin)};
  finding.verdict = all_of(finding.parts);
  note_means(finding, steady);
  return finding;
}

Finding heights_settle_small(const Study& study, std::size_t reading) {
  return heights_settle(study, kSmall, reading, 5);
}

Finding heights_settle_large(const Study& study, std::size_t reading) {
  return heights_settle(study, kLarge, reading, 10);
}

Finding turns_drop(const Study& study, std::size_t reading) {
  const Comparison both = study.compare(kSmall, reading);
  const auto own_change = [&](const char* what, std::size_t since, bool of_yin) {
    const Pairs change = pairs(both, change_since(since, turns_of));
    return Effect{
        .what = what, .unit = "turns", .change = mean_interval(of_yin ? change.yin : change.li), .hardly = 0.5};
  };
  Finding finding{.parts = {hardly_changes(plain_effect("Difference of turns after the first iteration", "turns",
                                                        pairs(both, mean_at(1, turns_of)))),
                            falls(own_change("Change after iteration 5, Yin 2021", 5, true)),
                            hardly_changes(own_change("Change after the first iteration, Li 2019", 1, false)),
                            falls(plain_effect("Difference at the end", "turns", pairs(both, final_mean(turns_of))))}};
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding first_length_shorter(const Study& study, std::size_t reading) {
  const Effect first =
      percent_effect("Length after the first iteration", pairs(study.compare(kLarge, reading), mean_at(1, length_of)));
  Finding finding{.parts = {falls(first)}, .ours = value_of(first)};
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding better_scores(const Study& study, std::size_t reading) {
  Finding finding;
  for (const Size size : {kSmall, kLarge}) {
    const Comparison both = study.compare(size, reading);
    const Effect score = percent_effect(on_size(size, "S"), pairs(both, final_mean(score_of)));
    finding.parts.push_back(falls(score));
    finding.parts.push_back(falls(percent_effect("mean S of the ants", pairs(both, final_mean(mean_score_of)))));
    finding.parts.push_back(
        falls(plain_effect("iteration of the last change of S", "", pairs(both, settled(score_of)))));
    if (const auto value = value_of(score)) finding.by_case.emplace_back(size_name(size), *value);
  }
  note_mean_of_cases(finding);
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding settles_earlier(const Study& study, std::size_t reading) {
  Finding finding;
  for (const Size size : {kSmall, kLarge}) {
    const Effect effect = plain_effect(on_size(size, "Iterations to the final length"), "",
                                       pairs(study.compare(size, reading), settled(length_of)));
    finding.parts.push_back(falls(effect));
    if (const auto value = value_of(effect)) finding.by_case.emplace_back(size_name(size), *value);
  }
  note_mean_of_cases(finding);
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding equal_heights(const Study& study, std::size_t reading) {
  constexpr double kMostly = 50;
  constexpr double kHardlyEver = 5;
  Finding finding;
  for (const Size size : {kSmall, kLarge}) {
    const FirstIterations first = first_iterations(study.compare(size, reading), 1);
    Part part{.words = fmt::format("{}: no first iterations to compare.", size_name(size))};
    if (first.unequal > 0) {
      const double share = 100 * static_cast<double>(first.same_height) / static_cast<double>(first.unequal);
      part.verdict = share >= kMostly       ? ClaimVerdict::holds
                     : share <= kHardlyEver ? ClaimVerdict::does_not_hold
                                            : ClaimVerdict::cannot_be_told;
      part.words = fmt::format("On {} F is equal in {:.1f} % of {} pairs of first iterations with unequal lengths.",
                               size_name(size), share, first.unequal);
      finding.by_case.emplace_back(size_name(size), share);
    }
    finding.parts.push_back(part);
  }
  note_mean_of_cases(finding);
  finding.verdict = all_of(finding.parts);
  return finding;
}

constexpr std::array<Asked, 13> kClaims{{
    {"length", "1. The route is 6.4 % shorter than the baseline's (map not stated; ours: 30x30)", kLengthChange_percent,
     "%", length},
    {"variance", "2. The variance of the best length over 30 runs is 85.78 % smaller (map not stated; ours: 30x30)",
     kVarianceChange_percent, "%", variance},
    {"turns-10x10", "3. 10x10: the best route has fewer turns, 4 against 6", -2.0, "turns", fewer_turns},
    {"turns-30x30", "4. 30x30: the best route has more turns, 19 against 16, yet is shorter", 3.0, "turns",
     more_turns_yet_shorter},
    {"mean-length-10x10", "5. 10x10: mean best lengths hardly differ", {}, "%", equal_lengths},
    {"first-length-10x10",
     "6. 10x10: in the first iteration the route is longer than the baseline's, later shorter",
     {},
     "%",
     longer_then_shorter},
    {"height-10x10", "7. 10x10: the height deviation is steady within 5 iterations, the baseline's later", 5.0, "",
     heights_settle_small},
    {"height-30x30", "8. 30x30: the height deviation is steady within 10 iterations, the baseline's later", 10.0, "",
     heights_settle_large},
    {"turns-curve-10x10",
     "9. 10x10: turns are equal at first and drop to fewer after iteration 5; the baseline's stay",
     {},
     "turns",
     turns_drop},
    {"first-length-30x30",
     "10. 30x30: in the first iteration the route is shorter than the baseline's",
     {},
     "%",
     first_length_shorter},
    {"composite", "11. Both: S and the ants' mean S are lower and settle earlier", {}, "%", better_scores},
    {"iterations", "12. Both: fewer iterations to the final length", {}, "", settles_earlier},
    {"equal-height",
     "13. Both: at the start the height deviations are equal, though the lengths are not",
     {},
     "%",
     equal_heights},
}};

/// "Another verdict under other readings: holds: as coded, no bounds."
std::string other_readings(const Study& study, const Asked& asked, ClaimVerdict main) {
  std::string words;
  for (const ClaimVerdict verdict : {ClaimVerdict::holds, ClaimVerdict::does_not_hold, ClaimVerdict::cannot_be_told}) {
    if (verdict == main) continue;
    std::string names;
    for (std::size_t r = 1; r < readings().size(); ++r)
      if (asked.ask(study, r).verdict == verdict) names += (names.empty() ? "" : ", ") + readings()[r].name;
    if (names.empty()) continue;
    std::string said = to_string(verdict);
    std::ranges::replace(said, '_', ' ');
    words += fmt::format("{} it {} with: {}", words.empty() ? " Under other readings" : ";", said, names);
  }
  return words.empty() ? " The same under every other reading." : words + ".";
}

Claim claim(const Study& study, const Asked& asked) {
  const Finding main = asked.ask(study, 0);
  Claim claim{.id = asked.id,
              .text = asked.text,
              .published = asked.published,
              .ours = main.ours,
              .unit = asked.unit,
              .verdict = main.verdict,
              .why = {},
              .by_case = main.by_case};
  for (const Part& part : main.parts) claim.why += (claim.why.empty() ? "" : " ") + part.words;
  claim.why += main.more + other_readings(study, asked, main.verdict);
  return claim;
}

}  // namespace

std::vector<Claim> claims(const Study& study) {
  std::vector<Claim> all;
  for (const Asked& asked : kClaims) all.push_back(claim(study, asked));
  return all;
}

}  // namespace alate::yin2021
