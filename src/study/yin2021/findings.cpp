#include "study/yin2021/findings.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace alate::yin2021 {

namespace {

Effect percent_effect(std::string what, const Pairs& pairs) {
  return alate::percent_effect(std::move(what), mean_interval(pairs.percent()));
}

Effect plain_effect(std::string what, std::string unit, const Pairs& pairs) {
  return alate::plain_effect(std::move(what), std::move(unit), mean_interval(pairs.differences()));
}

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
  for (const Size size : kBoth) {
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

/// Pairs of first iterations with unequal lengths in which F is equal, percent.
std::optional<double> equal_height_percent(const FirstIterations& first) {
  if (first.unequal == 0) return std::nullopt;
  return 100 * static_cast<double>(first.same_height) / static_cast<double>(first.unequal);
}

ClaimPart equal_height_part(Size size, const FirstIterations& first) {
  constexpr double kMostly = 50;
  constexpr double kHardlyEver = 5;
  const auto share = equal_height_percent(first);
  if (!share) return {.words = fmt::format("{}: no first iterations to compare.", size_name(size))};
  return {.words = fmt::format("On {} F is equal in {:.1f} % of {} pairs of first iterations with unequal lengths.",
                               size_name(size), *share, first.unequal),
          .verdict = *share >= kMostly       ? ClaimVerdict::holds
                     : *share <= kHardlyEver ? ClaimVerdict::does_not_hold
                                             : ClaimVerdict::cannot_be_told};
}

}  // namespace

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
  for (const Size size : kBoth) {
    const Comparison both = study.compare(size, reading);
    const Effect score = percent_effect(on_size(size, "S"), pairs(both, final_mean(score_of)));
    finding.parts.push_back(falls(score));
    finding.parts.push_back(falls(percent_effect("Mean S of the ants", pairs(both, final_mean(mean_score_of)))));
    finding.parts.push_back(
        falls(plain_effect("Iteration of the last change of S", "", pairs(both, settled(score_of)))));
    if (const auto value = value_of(score)) finding.by_case.emplace_back(size_name(size), *value);
  }
  note_mean_of_cases(finding);
  finding.verdict = all_of(finding.parts);
  return finding;
}

Finding settles_earlier(const Study& study, std::size_t reading) {
  Finding finding;
  for (const Size size : kBoth) {
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
  Finding finding;
  for (const Size size : kBoth) {
    const FirstIterations first = first_iterations(study.compare(size, reading), 1);
    finding.parts.push_back(equal_height_part(size, first));
    if (const auto share = equal_height_percent(first)) finding.by_case.emplace_back(size_name(size), *share);
    const auto coded = first_iterations(study.compare(size, reading_index(kHeightsAsCoded)), 1);
    if (const auto share = equal_height_percent(coded))
      finding.more += fmt::format(" With heights as coded it is in {:.1f} % on {}.", *share, size_name(size));
  }
  note_mean_of_cases(finding);
  finding.verdict = all_of(finding.parts);
  return finding;
}

}  // namespace alate::yin2021
