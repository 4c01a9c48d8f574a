// The witness is independent: it includes nothing that planners compute with.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace alate::test {
namespace {

std::vector<std::string> quoted_includes(const std::filesystem::path& folder) {
  std::vector<std::string> includes;
  const std::regex pattern(R"re(^\s*#\s*include\s*["<]([^">]*/[^">]*)[">])re");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path());
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
      if (std::regex_search(line, match, pattern)) includes.push_back(match[1]);
    }
  }
  return includes;
}

TEST(Independence, CheckIncludesCoreDataAndItselfOnly) {
  const std::filesystem::path source(ALATE_SOURCE_DIR);
  const std::regex allowed(R"(^(alate/core/|alate/data/|alate/check/|check/|Eigen/|fmt/|boost/math/).*)");
  std::size_t seen = 0;
  for (const auto& folder : {source / "src/check", source / "include/alate/check"}) {
    for (const std::string& include : quoted_includes(folder)) {
      ++seen;
      EXPECT_TRUE(std::regex_match(include, allowed)) << include;
    }
  }
  EXPECT_GT(seen, 20U);
}

}  // namespace
}  // namespace alate::test
