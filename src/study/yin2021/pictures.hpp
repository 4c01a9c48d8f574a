// The drawings of the reproduction page, as HTML figures.
#pragma once

#include "study/yin2021/figures.hpp"

namespace alate::yin2021 {

/// Best routes of both methods and of alate's own on the first map of a size.
std::string routes_picture(const Study& study, Size size);

/// L, F, T, S and the ants' mean S over the iterations, both methods, mean over the maps: one figure each.
std::string curves_pictures(const Study& study, Size size);

/// What changes on every map: the length with its spread, and the variance.
std::string maps_pictures(const Study& study, Size size);

}  // namespace alate::yin2021
