// docs/write-your-own-planner.md shows code that is built and run: each of its fenced blocks is a marked region of a
// file. The line before a block names both: <!-- examples/a.cpp [region] -->, or the file alone for the whole of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of_file(const std::string& file) {
  std::ifstream stream(std::string(ALATE_SOURCE_DIR "/") + file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The lines between `// [region]` and `// [/region]` (`#` for CMake), or all of them where no region is named.
std::optional<Lines> region_of(const Lines& lines, const std::string& region) {
  if (region.empty()) return lines;
  const auto marked = [&](const std::string& name) {
    return std::ranges::find_if(
        lines, [&](const std::string& line) { return line == "// [" + name + "]" || line == "# [" + name + "]"; });
  };
  const auto begin = marked(region);
  const auto end = marked("/" + region);
  if (begin == lines.end() || end == lines.end() || end < begin) return std::nullopt;
  return Lines(begin + 1, end);
}

struct Block {
  std::size_t line = 0;  ///< Of the page, from 1.
  std::string source;    ///< The line before it.
  Lines code;
};

std::vector<Block> blocks_of(const Lines& page) {
  std::vector<Block> blocks;
  bool open = false;
  for (std::size_t i = 0; i < page.size(); ++i) {
    if (page[i].starts_with("```")) {
      if (!open) blocks.push_back({.line = i + 1, .source = i > 0 ? page[i - 1] : "", .code = {}});
      open = !open;
    } else if (open) {
      blocks.back().code.push_back(page[i]);
    }
  }
  return blocks;
}

/// What is wrong with a block; empty if it equals its region.
std::string fault_of(const Block& block) {
  static const std::regex kSource(R"(^<!-- (\S+)(?: \[(\w+)\])? -->$)");
  std::smatch match;
  if (!std::regex_match(block.source, match, kSource)) return "names no source in the line before it";
  const Lines file = lines_of(text_of_file(match[1]));
  if (file.empty()) return "names a file that is not there: " + match[1].str();
  const auto region = region_of(file, match[2]);
  if (!region) return "names a region that is not there: " + match[2].str();
  return *region == block.code ? "" : "is not what stands in " + match[1].str();
}

std::string faults_of(const Lines& page) {
  std::string faults;
  for (const Block& block : blocks_of(page)) {
    const std::string fault = fault_of(block);
    if (!fault.empty()) faults += "line " + std::to_string(block.line) + ": " + fault + "\n";
  }
  return faults;
}

Lines guide() { return lines_of(text_of_file("docs/write-your-own-planner.md")); }

TEST(Guide, ShowsTheCodeThatIsRun) {
  EXPECT_EQ(faults_of(guide()), "");
  EXPECT_GE(blocks_of(guide()).size(), 10U);
}

TEST(Guide, AChangeOfAnyBlockIsFound) {
  for (const Block& block : blocks_of(guide())) {
    Lines page = guide();
    page[block.line] += " ";
    EXPECT_NE(faults_of(page), "") << block.line;
    page = guide();
    page[block.line - 2] = "";
    EXPECT_NE(faults_of(page).find("names no source"), std::string::npos) << block.line;
  }
}

TEST(Guide, RegionsThatAreNotThereAreFound) {
  EXPECT_NE(faults_of({"<!-- examples/own_policy/elitist.hpp [polcy] -->", "```cpp", "```"}).find("region"),
            std::string::npos);
  EXPECT_NE(faults_of({"<!-- examples/own_policy/elite.hpp [policy] -->", "```cpp", "```"}).find("file"),
            std::string::npos);
}

}  // namespace
