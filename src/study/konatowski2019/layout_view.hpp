// What the page shows of one layout: routes in space, how deep they enter the spheres, how the colonies converge.
#pragma once

#include <string>

#include "study/konatowski2019/study.hpp"

namespace alate::konatowski2019 {

std::string layout_view(const Study& study, std::size_t layout);

}  // namespace alate::konatowski2019
