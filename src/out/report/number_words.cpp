#include "out/report/number_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

constexpr std::string_view kThinSpace = "\u202F";
constexpr std::string_view kNoBreakSpace = "\u00A0";

/// Parts the digits before the point into groups of three from ten thousand on.
std::string grouped(std::string digits) {
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  if (point - first < 5) return digits;
  for (std::size_t i = point; i > first + 3; i -= 3) digits.insert(i - 3, kThinSpace);
  return digits;
}

/// Without zeros at the end: "300", "1.5".
std::string shortened(std::string digits) {
  if (digits.find('.') == std::string::npos) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.pop_back();
  return digits;
}

}  // namespace

std::string quantity(double value, std::string_view unit) {
  if (!std::isfinite(value)) return "–";
  const double size = std::abs(value);
  const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : 2;
  std::string digits = shortened(fmt::format("{:.{}f}", value, decimals));
  if (digits == "-0") digits = "0";
  if (unit == "deg" || unit == "°") return grouped(digits) + "°";
  return unit.empty() ? grouped(digits) : fmt::format("{}{}{}", grouped(digits), kNoBreakSpace, unit);
}

std::string whole(std::uint64_t count) { return grouped(fmt::format("{}", count)); }

}  // namespace alate
