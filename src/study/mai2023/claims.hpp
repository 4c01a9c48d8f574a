// The paper's claims beside our figures.
#pragma once

#include <vector>

#include "study/mai2023/figures.hpp"

namespace alate::mai2023 {

/// Superior on four measures in the simple and the medium scene, judged under the main reading; `why` names the
/// readings under which the verdict is another. The last is the complex scene, which cannot be told.
std::vector<Claim> claims(const Study& study);

}  // namespace alate::mai2023
