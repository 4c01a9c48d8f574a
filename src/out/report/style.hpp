// The style sheet of the report.
#pragma once

#include <string_view>

namespace alate {

/// Colours are told apart by lightness too; light and dark follow the reader's setting, print is light.
extern const std::string_view kStyle;

}  // namespace alate
