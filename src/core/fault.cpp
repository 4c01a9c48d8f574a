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

}  // namespace

std::string to_string(const Fault& fault) {
  std::string text;
  for (const std::string& part : {place_of(fault), fault.field}) {
    if (!part.empty()) text += part + ": ";
  }
  text += fault.message;
  const std::string unit = fault.unit.empty() ? "" : " " + fault.unit;
  std::string detail;
  if (!fault.value.empty()) detail = fmt::format("got {}", fault.value);
  if (!fault.limit.empty()) detail += fmt::format("{}allowed {}{}", detail.empty() ? "" : ", ", fault.limit, unit);
  if (!detail.empty()) text += fmt::format(" ({})", detail);
  return text;
}

InputError::InputError(std::vector<Fault> faults) : std::runtime_error(message_of(faults)), faults_(std::move(faults)) {
  assert(!faults_.empty());
}

InputError::InputError(Fault fault) : InputError(std::vector<Fault>{std::move(fault)}) {}

void throw_if_any(std::vector<Fault> faults) {
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace alate
