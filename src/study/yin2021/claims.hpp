// The paper's claims beside our figures.
#pragma once

#include <vector>

#include "study/yin2021/study.hpp"

namespace alate::yin2021 {

/// Claims 1 to 13, in the order of the paper, judged under the main reading; `why` names the readings under which the
/// verdict is another.
std::vector<Claim> claims(const Study& study);

}  // namespace alate::yin2021
