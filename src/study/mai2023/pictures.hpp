// The drawings of the reproduction page, as HTML figures.
#pragma once

#include <string>

#include "study/mai2023/figures.hpp"

namespace alate::mai2023 {

/// The best routes by F of both methods, and the best of all strings of moves, over the terrain.
std::string routes_picture(const Study& study, Scene scene);

/// The same routes cut upright, each with the ground below it.
std::string profiles_pictures(const Study& study, Scene scene);

/// Best F over the iterations, percent above the least: the methods, and their parts.
std::string curves_pictures(const Study& study, Scene scene);

}  // namespace alate::mai2023
