// From intervals to verdicts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "study/yin2021/figures.hpp"

namespace alate::yin2021 {

/// One sentence of a claim, judged.
struct Part {
  std::string words;  ///< What was found, with its interval.
  ClaimVerdict verdict = ClaimVerdict::cannot_be_told;
};

/// A change from the baseline to the new method, or a mean of one of them, over the maps.
struct Effect {
  std::string what;
  std::string unit;
  std::optional<Interval> change;  ///< Nothing where there are too few maps or runs.
  double hardly = 0;               ///< A change up to this is no difference worth the name.
  bool is_change = true;           ///< Told with its sign.
};

/// In percent of the baseline; up to 1 % is hardly a difference.
Effect percent_effect(std::string what, const Pairs& pairs);
/// In units of the figure ("turns", "iterations"); up to 0.5 is hardly a difference.
Effect plain_effect(std::string what, std::string unit, const Pairs& pairs);

/// Lower: holds where the whole interval lies below 0; does not where none of it lies below a negligible change.
Part falls(const Effect& effect);
/// Higher, likewise.
Part rises(const Effect& effect);
/// Holds where the whole interval is a negligible change; does not where none of it is.
Part hardly_changes(const Effect& effect);
/// A fall as large as `published` (< 0): holds where the interval lies below 0 and reaches it, does not where none of
/// it does.
Part falls_to(const Effect& effect, double published);
/// A mean over the maps, at most `limit`; above it.
Part at_most(const std::string& what, const std::optional<Interval>& mean, double limit);
Part above(const std::string& what, const std::optional<Interval>& mean, double limit);

/// All parts must hold; one that does not decides.
ClaimVerdict all_of(const std::vector<Part>& parts);
/// One part must hold; where none does, one that cannot be told decides.
ClaimVerdict any_of(const std::vector<Part>& parts);

/// "-0.31 % (-0.52 to -0.10)".
std::string change_words(const Interval& change, const std::string& unit);

}  // namespace alate::yin2021
