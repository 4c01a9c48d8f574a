// report.html: one page without scripts or outside references that shows why a route may be flown.
#pragma once

#include <string>

#include "alate/out/result.hpp"

namespace alate {

/// Valid HTML that is also well-formed XML.
std::string report_html(const Result& result);

}  // namespace alate
