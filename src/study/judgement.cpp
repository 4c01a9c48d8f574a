#include "study/judgement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

constexpr double kHardly_percent = 1;
constexpr double kHardly = 0.5;

/// The value stands before its interval, as `shown`.
std::string with_interval(const std::string& shown, const Interval& interval, int decimals) {
  return fmt::format("{} ({:.{}f} to {:.{}f})", shown, interval.low, decimals, interval.high, decimals);
}

int decimals_of(const Interval& interval) { return std::abs(interval.value) < 10 ? 2 : 1; }

std::string mean_words(const Interval& mean) {
  const int decimals = decimals_of(mean);
  return with_interval(fmt::format("{:.{}f}", mean.value, decimals), mean, decimals);
}

using Judge = ClaimVerdict (*)(const Interval&, double);

ClaimPart judged(const Effect& effect, Judge judge, double limit) {
  if (!effect.change) return {.words = fmt::format("{}: too few runs.", effect.what)};
  const std::string figure = effect.is_change ? change_words(*effect.change, effect.unit) : mean_words(*effect.change);
  return {.words = fmt::format("{}: {}.", effect.what, figure), .verdict = judge(*effect.change, limit)};
}

ClaimVerdict decide(bool holds, bool fails) {
  if (holds) return ClaimVerdict::holds;
  return fails ? ClaimVerdict::does_not_hold : ClaimVerdict::cannot_be_told;
}

}  // namespace

std::string change_words(const Interval& change, const std::string& unit) {
  const int decimals = decimals_of(change);
  return with_interval(fmt::format("{:+.{}f}{}{}", change.value, decimals, unit.empty() ? "" : " ", unit), change,
                       decimals);
}

Effect percent_effect(std::string what, const std::optional<Interval>& percent) {
  return {.what = std::move(what), .unit = "%", .change = percent, .hardly = kHardly_percent};
}

Effect plain_effect(std::string what, std::string unit, const std::optional<Interval>& difference) {
  return {.what = std::move(what), .unit = std::move(unit), .change = difference, .hardly = kHardly};
}

ClaimPart falls(const Effect& effect) {
  return judged(
      effect, [](const Interval& change, double hardly) { return decide(change.high < 0, change.low >= -hardly); },
      effect.hardly);
}

ClaimPart rises(const Effect& effect) {
  return judged(
      effect, [](const Interval& change, double hardly) { return decide(change.low > 0, change.high <= hardly); },
      effect.hardly);
}

ClaimPart hardly_changes(const Effect& effect) {
  return judged(
      effect,
      [](const Interval& change, double hardly) {
        return decide(change.low >= -hardly && change.high <= hardly, change.low > hardly || change.high < -hardly);
      },
      effect.hardly);
}

ClaimPart falls_to(const Effect& effect, double published) {
  return judged(
      effect,
      [](const Interval& change, double limit) {
        return decide(change.high < 0 && change.low <= limit, change.low > limit);
      },
      published);
}

ClaimPart at_most(const std::string& what, const std::optional<Interval>& mean, double limit) {
  return judged(
      {.what = what, .unit = "", .change = mean, .is_change = false},
      [](const Interval& value, double most) { return decide(value.high <= most, value.low > most); }, limit);
}

ClaimPart above(const std::string& what, const std::optional<Interval>& mean, double limit) {
  return judged(
      {.what = what, .unit = "", .change = mean, .is_change = false},
      [](const Interval& value, double least) { return decide(value.low > least, value.high <= least); }, limit);
}

ClaimVerdict all_of(const std::vector<ClaimPart>& parts) {
  const auto is = [](ClaimVerdict verdict) { return [=](const ClaimPart& part) { return part.verdict == verdict; }; };
  return decide(!parts.empty() && std::ranges::all_of(parts, is(ClaimVerdict::holds)),
                std::ranges::any_of(parts, is(ClaimVerdict::does_not_hold)));
}

ClaimVerdict any_of(const std::vector<ClaimPart>& parts) {
  const auto is = [](ClaimVerdict verdict) { return [=](const ClaimPart& part) { return part.verdict == verdict; }; };
  return decide(std::ranges::any_of(parts, is(ClaimVerdict::holds)),
                !parts.empty() && std::ranges::all_of(parts, is(ClaimVerdict::does_not_hold)));
}

}  // namespace alate
