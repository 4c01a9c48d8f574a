// All methods on all cases at a glance.
#pragma once

#include <string>

#include "study/konatowski2019/study.hpp"

namespace alate::konatowski2019 {

/// Mean cost of each method above the best cost known of each case, percent, and mean time.
std::string overview_table(const Study& study);

}  // namespace alate::konatowski2019
