#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <memory>

namespace alate {

namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool names_no_finite_number(std::string_view text) {
  if (text.size() > 9) return false;
  std::string lower(text.starts_with('.') ? text.substr(1) : text);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array<std::string_view, 3> kNames{"nan", "inf", "infinity"};
  return std::ranges::find(kNames, lower) != kNames.end();
}

bool hints_at_another_base(std::string_view text) {
  if (text.size() < 2 || text[0] != '0') return false;
  return is_digit(text[1]) || std::string_view("xXoObB").find(text[1]) != std::string_view::npos;
}

}  // namespace

NumberText parse_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view body = negative || text.starts_with('+') ? text.substr(1) : text;
  if (names_no_finite_number(body)) return {.problem = "must be finite"};
  if (hints_at_another_base(body)) return {.problem = "must be a decimal number without leading zeros"};
  if (body.empty() || (!is_digit(body[0]) && body[0] != '.')) return {.problem = "must be a number"};

  double value = 0;
  const char* begin = std::to_address(body.begin());
  const char* end = std::to_address(body.end());
  const auto [stopped, error] = std::from_chars(begin, end, value);
  if (stopped != end || error == std::errc::invalid_argument) return {.problem = "must be a number"};
  if (error == std::errc::result_out_of_range) return {.problem = "is too large or too small for a number"};
  return {.value = negative ? -value : value};
}

}  // namespace alate
