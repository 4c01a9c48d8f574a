// reproduce.html of Konatowski and Pawlowski 2019.
#pragma once

#include <string>

#include "alate/study/reproduce.hpp"
#include "study/konatowski2019/study.hpp"

namespace alate::konatowski2019 {

std::string page_html(const Study& study, const Reproduction& result);

}  // namespace alate::konatowski2019
