// A whole file in memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "alate/core/fault.hpp"

namespace alate {

/// What the file holds, without a byte order mark. Throws InputError if it is no plain file, cannot be read or has more
/// than `most_bytes`.
std::string read_text_file(const std::string& file, std::size_t most_bytes);

/// Where `text` holds anything but plain ASCII, without the file's name; nothing if it does not.
std::optional<Fault> binary_fault(std::string_view text);

/// The lines of a text one after the other, without blanks at their ends; lines of blanks are passed over.
struct TextLines {
  std::string_view rest;
  std::string_view line;
  int number = 0;  ///< Of the line, from 1.

  /// False at the end of the text.
  bool next();
};

}  // namespace alate
