// reproduce.html of Mai et al. 2023.
#pragma once

#include <string>

#include "alate/study/reproduce.hpp"
#include "study/mai2023/study.hpp"

namespace alate::mai2023 {

std::string page_html(const Study& study, const Reproduction& result);

}  // namespace alate::mai2023
