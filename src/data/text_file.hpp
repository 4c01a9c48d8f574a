// A whole file in memory.
#pragma once

#include <cstddef>
#include <string>

namespace alate {

/// What the file holds, without a byte order mark. Throws InputError if it is no plain file, cannot be read or has more
/// than `most_bytes`.
std::string read_text_file(const std::string& file, std::size_t most_bytes);

}  // namespace alate
