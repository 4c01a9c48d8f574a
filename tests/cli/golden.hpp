// Results kept as files. ALATE_UPDATE_GOLDEN=1 writes them anew; look at the difference before you commit it.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "support/process.hpp"

namespace alate::test {

/// A result without what differs from run to run, from folder to folder or with the number of threads.
inline nlohmann::json lasting(nlohmann::json result) {
  for (const char* key : {"wall_s", "threads"}) result["counters"].erase(key);
  for (const char* key : {"files", "scenario"}) result.erase(key);
  return result;
}

/// Numbers to 1e-9 relative, or 1e-9 around zero (exp and sin differ between C libraries); all else exactly.
/// Returns the path of the first difference, or nothing.
inline std::string difference(const nlohmann::json& a, const nlohmann::json& b, const std::string& path = "") {
  if (a.is_number_float() || b.is_number_float()) {
    if (!a.is_number() || !b.is_number()) return path;
    const double x = a;
    const double y = b;
    return std::abs(x - y) <= 1e-9 * std::max({1.0, std::abs(x), std::abs(y)}) ? "" : path;
  }
  if (!a.is_structured() || a.type() != b.type() || a.size() != b.size()) return a == b ? "" : path + "/";
  for (const auto& [key, value] : a.items()) {
    std::string below = fmt::format("{}/{}", path, key);
    if (a.is_object() && !b.contains(key)) return below;
    std::string found = difference(value, a.is_object() ? b.at(key) : b.at(std::stoul(key)), below);
    if (!found.empty()) return found;
  }
  return "";
}

/// Compares with tests/cli/golden/NAME.json.
inline std::string difference_from_golden(const nlohmann::json& result, const std::string& name) {
  const std::string file = ALATE_SOURCE_DIR "/tests/cli/golden/" + name + ".json";
  if (std::getenv("ALATE_UPDATE_GOLDEN") != nullptr) write_file(file, result.dump(1) + "\n");
  return difference(nlohmann::json::parse(read_file(file)), result);
}

}  // namespace alate::test
