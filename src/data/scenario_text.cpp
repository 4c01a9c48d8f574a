#include "data/scenario_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "data/limits.hpp"

namespace alate {

namespace {

/// At most one byte more than the limit, so that endless inputs end.
std::string read_limited(std::istream& stream) {
  std::string text(kMaxScenarioBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// Bytes of the UTF-8 character at `at`; 0 if there is none.
std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0U) != 0x80U) return 0;
  }
  const unsigned second = byte(at + 1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool not_a_character = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return overlong || not_a_character ? 0 : length;
}

/// Line of the first byte that no text holds; 0 if all is text.
int line_of_binary(const std::string& text) {
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0 || is_control(text[at])) return line;
    if (text[at] == '\n') ++line;
    at += length;
  }
  return 0;
}

}  // namespace

std::string read_scenario_text(const std::string& file, std::vector<Fault>& faults) {
  if (file == "-") return read_limited(std::cin);
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const auto refuse = [&](const char* message) {
    faults.push_back({.file = file, .message = message});
    return std::string();
  };
  if (!std::filesystem::exists(status)) return refuse("no such file");
  if (std::filesystem::is_directory(status)) return refuse("is a folder, not a scenario file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refuse("cannot be read");
  return read_limited(stream);
}

void check_scenario_text(const std::string& text, const std::string& file, std::vector<Fault>& faults) {
  if (text.size() > kMaxScenarioBytes) {
    faults.push_back(
        {.file = file, .limit = fmt::format("{}", kMaxScenarioBytes), .unit = "bytes", .message = "too large"});
  } else if (const int line = line_of_binary(text); line > 0) {
    faults.push_back({.file = file, .line = line, .message = "not a text file in UTF-8"});
  } else if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    faults.push_back({.file = file, .message = "the file is empty"});
  }
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kLength = 80;
  if (text.size() <= kLength) return text;
  std::size_t end = kLength;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

}  // namespace alate
