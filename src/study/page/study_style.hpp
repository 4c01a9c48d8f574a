// What pages of studies need beyond the style sheet of the report.
#pragma once

#include <string_view>

namespace alate {

/// Classes w0, w1, w2 tell the lines of one drawing apart by colour and dash.
extern const std::string_view kStudyStyle;

}  // namespace alate
