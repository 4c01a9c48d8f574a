// Text files that hold one record a line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/route_builder.hpp"

namespace alate {

struct TextLine {
  int number = 0;  ///< 1-based.
  std::string_view text;
};

/// Lines that hold more than spaces, without their ends (LF or CRLF).
std::vector<TextLine> lines_of(std::string_view text);

/// A finite decimal number in a cell; nothing for an empty cell; a fault for anything else.
std::optional<double> cell_number(std::string_view cell, const Origin& origin, RouteBuilder& builder);

/// A whole number in a cell; nothing for an empty cell; a fault for anything else.
std::optional<int> cell_integer(std::string_view cell, const Origin& origin, RouteBuilder& builder);

}  // namespace alate
