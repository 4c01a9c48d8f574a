#include "data/text_file.hpp"

#include <fmt/core.h>
#include <algorithm>

#include <filesystem>
#include <fstream>

#include "data/scenario_text.hpp"

namespace alate {

std::string read_text_file(const std::string& file, std::size_t most_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(Fault{.file = file, .message = "no such file"});
  if (!std::filesystem::is_regular_file(status)) throw InputError(Fault{.file = file, .message = "is not a file"});
  std::ifstream stream(file, std::ios::binary);
  const auto size = std::filesystem::file_size(file, error);
  if (!stream || error) throw InputError(Fault{.file = file, .message = "cannot be read"});
  if (size > most_bytes) {
    throw InputError(Fault{.file = file,
                           .value = fmt::format("{}", size),
                           .limit = fmt::format("<= {}", most_bytes),
                           .unit = "bytes",
                           .message = "too large"});
  }
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return text;
}

std::optional<Fault> binary_fault(std::string_view text) {
  const auto binary = [](char c) { return static_cast<unsigned char>(c) >= 0x80 || is_control(c); };
  const auto* const found = std::ranges::find_if(text, binary);
  if (found == text.end()) return std::nullopt;
  const std::string_view before(text.begin(), found);
  return Fault{.line = static_cast<int>(std::ranges::count(before, '\n')) + 1,
               .column = static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1,
               .message = "is not a text file"};
}

bool TextLines::next() {
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) return true;
  }
  return false;
}

}  // namespace alate
