// reproduce.html of Zhou et al. 2020.
#pragma once

#include <string>
#include <vector>

#include "study/zhou2020/claims.hpp"

namespace alate::zhou2020 {

std::string page_html(const Study& study, const std::vector<JudgedRow>& rows, const Reproduction& result);

}  // namespace alate::zhou2020
