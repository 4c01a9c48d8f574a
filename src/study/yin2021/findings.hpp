// What a reading says about each claim of the paper.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "study/judgement.hpp"
#include "study/yin2021/figures.hpp"

namespace alate::yin2021 {

/// What one reading says about a claim.
struct Finding {
  std::vector<ClaimPart> parts;
  ClaimVerdict verdict = ClaimVerdict::cannot_be_told;
  std::optional<double> ours;
  std::vector<std::pair<std::string, double>> by_case;
  std::string more;  ///< Sentences beyond the parts.
};

/// Claims 1 and 2 name no map: both sizes are tried, either may bear them out, and `ours` is of the larger.
Finding length(const Study& study, std::size_t reading);
Finding variance(const Study& study, std::size_t reading);
/// Claims 3 and 4, of the run with the least S on each map.
Finding fewer_turns(const Study& study, std::size_t reading);
Finding more_turns_yet_shorter(const Study& study, std::size_t reading);
/// Claims 5 to 10.
Finding equal_lengths(const Study& study, std::size_t reading);
Finding longer_then_shorter(const Study& study, std::size_t reading);
Finding heights_settle_small(const Study& study, std::size_t reading);
Finding heights_settle_large(const Study& study, std::size_t reading);
Finding turns_drop(const Study& study, std::size_t reading);
Finding first_length_shorter(const Study& study, std::size_t reading);
/// Claims 11 to 13, of both sizes.
Finding better_scores(const Study& study, std::size_t reading);
Finding settles_earlier(const Study& study, std::size_t reading);
Finding equal_heights(const Study& study, std::size_t reading);

}  // namespace alate::yin2021
