// The tables of the reproduction page, as HTML.
#pragma once

#include "study/yin2021/summary.hpp"

namespace alate::yin2021 {

/// Methods of the main reading on one size: length, gap to the optimum, F, T, S, spread, iterations, time.
std::string methods_table(const Study& study, Size size);

/// Every reading on one size: changes from the baseline to the new method, with intervals.
std::string readings_table(const Study& study, Size size);

/// Every map of one size: optimum, both methods, their difference.
std::string maps_table(const Study& study, Size size);

}  // namespace alate::yin2021
