// Text of a scenario file, fit to be parsed.
#pragma once

#include <string>
#include <vector>

#include "alate/core/fault.hpp"

namespace alate {

/// Reads a file, or standard input for "-", never more than the limit. Faults: missing, a folder, unreadable, too
/// large. The text is empty after a fault.
std::string read_scenario_text(const std::string& file, std::vector<Fault>& faults);

/// Faults of the text as such: empty, too large, not UTF-8, control characters (binary files).
void check_scenario_text(const std::string& text, const std::string& file, std::vector<Fault>& faults);

/// Is a byte of UTF-8 text a control character other than tab and line ends?
constexpr bool is_control(char c) {
  return (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
}

/// Text as faults show it: shortened to a line's length.
std::string shortened(const std::string& text);

}  // namespace alate
