// The paper's claims beside our figures.
#pragma once

#include <vector>

#include "study/konatowski2019/study.hpp"

namespace alate::konatowski2019 {

/// The nine published numbers, what follows from them alone, and what the paper says of trends and next steps.
std::vector<Claim> claims(const Study& study);

}  // namespace alate::konatowski2019
