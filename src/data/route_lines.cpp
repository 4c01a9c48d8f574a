#include "data/route_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/number_text.hpp"
#include "data/scenario_text.hpp"

namespace alate {

std::vector<TextLine> lines_of(std::string_view text) {
  std::vector<TextLine> lines;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.find_first_not_of(" \t") != std::string_view::npos) lines.push_back({number, line});
  }
  return lines;
}

std::optional<double> cell_number(std::string_view cell, const Origin& origin, RouteBuilder& builder) {
  if (cell.empty()) return std::nullopt;
  const NumberText number = parse_number(cell);
  if (number.problem.empty()) return number.value;
  builder.refuse(
      {.line = origin.line, .field = origin.field, .value = shortened(std::string(cell)), .message = number.problem});
  return std::nullopt;
}

std::optional<int> cell_integer(std::string_view cell, const Origin& origin, RouteBuilder& builder) {
  const auto number = cell_number(cell, origin, builder);
  if (!number) return std::nullopt;
  if (std::abs(*number) <= std::numeric_limits<int>::max() && std::trunc(*number) == *number) {
    return static_cast<int>(*number);
  }
  builder.refuse({.line = origin.line,
                  .field = origin.field,
                  .value = shortened(std::string(cell)),
                  .message = "must be a whole number"});
  return std::nullopt;
}

}  // namespace alate
