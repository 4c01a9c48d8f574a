// The one way to read a number that a user wrote.
#pragma once

#include <string>
#include <string_view>

namespace alate {

/// A number, or why the text is none.
struct NumberText {
  double value = 0;
  std::string problem;  ///< Empty if `value` holds the number.
};

/// Reads a decimal number, independent of the locale: `-1.5e3`, `+2`, `.5`. Refused are NaN and infinity, numbers
/// too large or small for a double, and leading zeros, `0x` and `0o`, which YAML readers take for other bases.
NumberText parse_number(std::string_view text);

}  // namespace alate
