// The tables of the page, as HTML.
#pragma once

#include <string>

#include "study/mai2023/figures.hpp"

namespace alate::mai2023 {

/// The four measures of all methods on a scene: mean, best, worst, standard deviation.
std::string methods_table(const Study& study, Scene scene);

/// What each reading changes from the baseline to the paper's method.
std::string readings_table(const Study& study, Scene scene);

}  // namespace alate::mai2023
