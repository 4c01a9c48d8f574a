// From intervals to verdicts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "alate/study/reproduce.hpp"
#include "study/bootstrap.hpp"

namespace alate {

/// One sentence of a claim, judged.
struct ClaimPart {
  std::string words;  ///< What was found, with its interval.
  ClaimVerdict verdict = ClaimVerdict::cannot_be_told;
};

/// A change from the baseline to the new method, or a mean of one of them, over maps or runs.
struct Effect {
  std::string what;
  std::string unit;
  std::optional<Interval> change;  ///< Nothing where there are too few maps or runs.
  double hardly = 0;               ///< A change up to this is no difference worth the name.
  bool is_change = true;           ///< Told with its sign.
};

/// In percent of the baseline; up to 1 % is hardly a difference.
Effect percent_effect(std::string what, const std::optional<Interval>& percent);
/// In units of the figure ("turns", "iterations"); up to 0.5 is hardly a difference.
Effect plain_effect(std::string what, std::string unit, const std::optional<Interval>& difference);

/// Lower: holds where the whole interval lies below 0; does not where none of it lies below a negligible change.
ClaimPart falls(const Effect& effect);
/// Higher, likewise.
ClaimPart rises(const Effect& effect);
/// Holds where the whole interval is a negligible change; does not where none of it is.
ClaimPart hardly_changes(const Effect& effect);
/// A fall as large as `published` (< 0): holds where the interval lies below 0 and reaches it, does not where none of
/// it does.
ClaimPart falls_to(const Effect& effect, double published);
/// A mean, at most `limit`; above it.
ClaimPart at_most(const std::string& what, const std::optional<Interval>& mean, double limit);
ClaimPart above(const std::string& what, const std::optional<Interval>& mean, double limit);

/// All parts must hold; one that does not decides.
ClaimVerdict all_of(const std::vector<ClaimPart>& parts);
/// One part must hold; where none does, one that cannot be told decides.
ClaimVerdict any_of(const std::vector<ClaimPart>& parts);

/// "-0.31 % (-0.52 to -0.10)".
std::string change_words(const Interval& change, const std::string& unit);

}  // namespace alate
