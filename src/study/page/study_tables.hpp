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

/// The head of a page: what it is, and the paper.
std::string reproduction_header(const Reproduction& result);

/// What must be known before any figure is read, numbered.
std::string notes_list(const std::vector<std::string>& notes);

std::string defects_list(const std::vector<Defect>& defects);

/// One figure of the row at the top of a page. Both are HTML already.
std::string fact(const std::string& value, const std::string& name);

/// How many claims hold and how many do not, how many runs; `more` facts after them.
std::string verdict_facts(const Reproduction& result, const std::string& more = {});

/// All that is needed to do it again.
std::string settings_section(const Reproduction& result);

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
