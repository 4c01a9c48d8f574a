// What is wrong with the published definition, in plain words.
#pragma once

#include <vector>

#include "study/zhou2020/study.hpp"

namespace alate::zhou2020 {

std::vector<Defect> defects(const Study& study);

}  // namespace alate::zhou2020
