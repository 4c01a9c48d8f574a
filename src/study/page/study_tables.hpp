// Tables that every reproduction shows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "alate/study/reproduce.hpp"

namespace alate {

/// Published beside ours, with verdict and reason.
std::string claims_table(const std::vector<Claim>& claims);

/// One block a case; the least mean of a case is marked.
std::string cells_table(const std::vector<Cell>& cells);

std::string defects_list(const std::vector<Defect>& defects);

/// A table with heads for words and for numbers. `rows` are HTML already, heads are escaped.
std::string study_table(const std::vector<std::string>& words, const std::vector<std::string>& numbers,
                        const std::string& rows);

/// "does not hold".
std::string verdict_words(ClaimVerdict verdict);

/// "34.5", finer below a hundredth of a second.
std::string milliseconds(double seconds);

/// A fixed number of decimals; a dash for nothing.
std::string fixed(const std::optional<double>& value, int decimals);

}  // namespace alate
