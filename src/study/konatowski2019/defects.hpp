// What is wrong with the published definition, each with a figure of ours.
#pragma once

#include <vector>

#include "study/konatowski2019/study.hpp"

namespace alate::konatowski2019 {

std::vector<Defect> defects(const Study& study);

}  // namespace alate::konatowski2019
