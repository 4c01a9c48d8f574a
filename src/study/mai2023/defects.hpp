// What is odd or open in the published method, in plain words, and what it does.
#pragma once

#include <vector>

#include "study/mai2023/figures.hpp"

namespace alate::mai2023 {

std::vector<Defect> defects(const Study& study);

}  // namespace alate::mai2023
