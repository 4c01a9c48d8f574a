#include "alate/core/fault.hpp"

#include <fmt/core.h>

#include <cassert>

namespace alate {

namespace {

std::string message_of(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += to_string(fault);
  }
  return text;
}

std::string place_of(const Fault& fault) {
  if (fault.file.empty() || fault.line == 0) return fault.file;
  if (fault.column == 0) return fmt::format("{}:{}", fault.file, fault.line);
  return fmt::format("{}:{}:{}", fault.file, fault.line, fault.column);
}

std::string detail_of(const Fault& fault) {
  const std::string unit = fault.unit.empty() ? "" : fmt::format(" {}", fault.unit);
  if (fault.limit.empty()) return fault.value.empty() ? "" : fmt::format(" (got {})", fault.value);
  if (fault.value.empty()) return fmt::format(" (allowed {}{})", fault.limit, unit);
  return fmt::format(" (got {}, allowed {}{})", fault.value, fault.limit, unit);
}

/// Control characters, which could command a terminal, as `\x1b`.
std::string printable(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string text;
  for (const std::string& part : {place_of(fault), fault.field}) {
    if (!part.empty()) text += part + ": ";
  }
  return printable(text + fault.message + detail_of(fault));
}

InputError::InputError(std::vector<Fault> faults) : std::runtime_error(message_of(faults)), faults_(std::move(faults)) {
  assert(!faults_.empty());
}

InputError::InputError(Fault fault) : InputError(std::vector<Fault>{std::move(fault)}) {}

void throw_if_any(std::vector<Fault> faults) {
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace alate
