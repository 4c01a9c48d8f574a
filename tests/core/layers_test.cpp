// The house has floors: an include may only point downward (docs/architecture.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> kMayInclude{
    {"core", {"core"}},
    {"data", {"core", "data"}},
    {"world", {"core", "data", "world"}},
    {"space", {"core", "data", "world", "space"}},
    {"search", {"core", "data", "world", "space", "search"}},
    {"aco", {"core", "data", "world", "space", "aco"}},
    {"ga", {"core", "data", "world", "space", "search", "ga"}},
    {"plan", {"core", "data", "world", "space", "search", "aco", "ga", "plan"}},
    {"check", {"core", "data", "check"}},
    {"out", {"core", "data", "world", "space", "search", "aco", "ga", "plan", "check", "out"}},
    {"study", {"core", "data", "world", "space", "search", "aco", "ga", "plan", "check", "out", "study"}},
};

/// Module that an include line names: "alate/data/site.hpp" and "data/limits.hpp" are both `data`.
std::string module_of(const std::string& include) {
  static const std::regex kInclude(R"re(^\s*#include "(?:alate/)?(?:([a-z_]+)/)?[^"]*")re");
  std::smatch match;
  return std::regex_search(include, match, kInclude) ? match[1].str() : "";
}

void expect_downward(const fs::path& file, const std::string& module) {
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    const std::string included = module_of(line);
    if (!kMayInclude.contains(included)) continue;
    EXPECT_TRUE(kMayInclude.at(module).contains(included)) << file << " includes upward or sideways: " << line;
  }
}

/// Types of a file that other files can see: outside unnamed namespaces, with the namespaces around them.
std::set<std::string> types_of(const fs::path& file) {
  static const std::regex kNamespace(R"re(^(?:inline )?namespace ([a-z0-9_:]*) ?\{)re");
  static const std::regex kEnd(R"re(^\}\s*// namespace ?([a-z0-9_:]*))re");
  static const std::regex kType(
      R"re(^(?:struct|class|enum|enum class) (?:alignas\([^)]*\) )?(\w+)(?: final)?(?: :.*)?(?: \{|$))re");
  std::set<std::string> types;
  std::vector<std::string> around;
  std::ifstream text(file);
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_search(line, match, kNamespace)) around.push_back(match[1].str());
    if (std::regex_search(line, match, kEnd) && !around.empty()) around.pop_back();
    if (!std::regex_search(line, match, kType) || std::ranges::count(around, "") > 0) continue;
    std::string name;
    for (const std::string& space : around) name += space + "::";
    types.insert(name + match[1].str());
  }
  return types;
}

/// Two types of one name in one namespace are undefined behaviour that no compiler tells: the linker takes one of them.
TEST(Layers, NoTwoTypesShareAName) {
  std::map<std::string, fs::path> seen;
  for (const std::string root : {"src", "include/alate", "apps"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ALATE_SOURCE_DIR) / root)) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      for (const std::string& type : types_of(entry.path())) {
        const auto [first, is_new] = seen.emplace(type, entry.path());
        EXPECT_TRUE(is_new) << type << " is in " << first->second << " and in " << entry.path();
      }
    }
  EXPECT_GT(seen.size(), 300U);
  EXPECT_TRUE(seen.contains("alate::Site"));
}

TEST(Layers, IncludesPointDownward) {
  std::size_t files = 0;
  for (const std::string root : {"src", "include/alate"}) {
    for (const auto& [module, allowed] : kMayInclude) {
      const fs::path folder = fs::path(ALATE_SOURCE_DIR) / root / module;
      if (!fs::exists(folder)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || entry.path().extension() == ".txt") continue;
        expect_downward(entry.path(), module);
        ++files;
      }
    }
  }
  EXPECT_GT(files, 30U);
}

TEST(Layers, GdalStaysInData) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ALATE_SOURCE_DIR) / "src")) {
    if (!entry.is_regular_file() || entry.path().parent_path().filename() == "data") continue;
    std::ifstream text(entry.path());
    for (std::string line; std::getline(text, line);) {
      EXPECT_EQ(line.find("#include <gdal"), std::string::npos) << entry.path();
      EXPECT_EQ(line.find("#include <ogr"), std::string::npos) << entry.path();
    }
  }
}

}  // namespace
