// reproduce.html of Yin et al. 2021.
#pragma once

#include <string>

#include "alate/study/reproduce.hpp"
#include "study/yin2021/study.hpp"

namespace alate::yin2021 {

std::string page_html(const Study& study, const Reproduction& result);

}  // namespace alate::yin2021
