#include "data/grid_map.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "data/limits.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

const std::string kSmall = "type octile\nheight 2\nwidth 7\nmap\n.GS@OTW\nW......\n";

/// `text` in a file of its own, read.
struct Reading {
  explicit Reading(const std::string& text) {
    // Tests run side by side.
    const std::string file = fmt::format("{}alate_grid_{}.map", testing::TempDir(),
                                         testing::UnitTest::GetInstance()->current_test_info()->name());
    std::ofstream(file, std::ios::binary) << text;
    grid = read_grid_map(file, faults);
    EXPECT_EQ(grid.has_value(), faults.empty());
    for (Fault& fault : faults) {
      EXPECT_EQ(fault.file, file);
      fault.file = "m.map";
    }
  }
  std::string all_faults() const {
    std::string all;
    for (const Fault& fault : faults) all += to_string(fault) + "\n";
    return all;
  }

  std::optional<HeightGrid> grid;
  std::vector<Fault> faults;
};

std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

TEST(GridMap, LettersAndBothKindsOfLineEnds) {
  for (const std::string& text : {kSmall, with_crlf(kSmall), kSmall + "\n \r\n", kSmall.substr(0, kSmall.size() - 1)}) {
    const Reading read(text);
    ASSERT_EQ(read.all_faults(), "");
    EXPECT_EQ(read.grid->columns, 7);
    EXPECT_EQ(read.grid->rows, 2);
    EXPECT_EQ(read.grid->blocked, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(read.grid->height_m.empty());
  }
}

TEST(GridMap, RowZeroIsInTheNorth) {
  const Reading read(kSmall);
  EXPECT_EQ(read.grid->center(0, 0), Vec3(0.5, 1.5, 0));
  EXPECT_EQ(read.grid->center(6, 1), Vec3(6.5, 0.5, 0));
}

TEST(GridMap, EveryFaultIsToldAtOnceWithItsPlace) {
  EXPECT_EQ(Reading("type octile\nheight 3\nwidth 4\nmap\n.x..\n...\n.....\n..#.\n").all_faults(),
            "m.map:5:2: unknown cell (got x, allowed . G S (free) | @ O T W (blocked))\n"
            "m.map:6:4: the row is not as long as `width` says (got 3, allowed 4 cells)\n"
            "m.map:7:5: the row is not as long as `width` says (got 5, allowed 4 cells)\n"
            "m.map:8: there are not as many rows as `height` says (got 4, allowed 3 rows)\n");
  EXPECT_EQ(Reading("type tile\nheight x\nwidth 0\ndepth 3\nmap\n..\n").all_faults(),
            "m.map:1:1: unknown line of the header (got type tile, allowed type octile | height N | width N | map)\n"
            "m.map:2:8: height: must be a whole number in range (got x, allowed 1 to 10000 cells)\n"
            "m.map:3:7: width: must be a whole number in range (got 0, allowed 1 to 10000 cells)\n"
            "m.map:4:1: unknown line of the header (got depth 3, allowed type octile | height N | width N | map)\n");
  EXPECT_EQ(Reading("type octile\nheight 2\nmap\n..\n..\n").all_faults(), "m.map:1: width: is missing in the header\n");
}

TEST(GridMap, WhatIsNoMapIsRefused) {
  EXPECT_EQ(Reading("").all_faults(), "m.map: the file is empty\n");
  EXPECT_EQ(Reading(" \r\n\n").all_faults(), "m.map: the file is empty\n");
  EXPECT_EQ(Reading(std::string("type octile\nhei\0ght", 19)).all_faults(), "m.map:2:4: is not a text file\n");
  EXPECT_EQ(Reading("type octile\nheight 2\nwidth 2\nmap\n.\xff\n..\n").all_faults(),
            "m.map:5:2: is not a text file\n");
  EXPECT_EQ(Reading("type octile\nheight 2\nwidth 2\n..\n..\n").all_faults(),
            "m.map:4: the last line of the header is missing (allowed map)\n");
  EXPECT_EQ(Reading("type octile\nheight 9000\nwidth 9000\nmap\n..\n").all_faults(),
            "m.map:1: too many cells (got 81000000, allowed <= 16000000 cells)\n");
  EXPECT_EQ(Reading("type octile\nheight 99999999999\nwidth 2\nmap\n..\n").all_faults(),
            "m.map:2:8: height: must be a whole number in range (got 99999999999, allowed 1 to 10000 cells)\n");
  EXPECT_EQ(Reading(std::string(kMaxGridBytes + 1, '.')).all_faults(),
            "m.map: too large (got 33554433, allowed <= 33554432 bytes)\n");
}

TEST(GridMap, MissingFileAndFolder) {
  for (const std::string& file : {testing::TempDir() + "alate_no_such.map", testing::TempDir()}) {
    std::vector<Fault> faults;
    EXPECT_FALSE(read_grid_map(file, faults));
    EXPECT_EQ(faults.size(), 1U);
  }
}

TEST(GridMap, ManyFaultsAreCounted) {
  const Reading read("type octile\nheight 1\nwidth 5000\nmap\n" + std::string(5000, 'x') + "\n");
  ASSERT_EQ(read.faults.size(), kMaxFaults + 1);
  EXPECT_EQ(read.faults.back().message, "and 4900 more faults");
}

TEST(GridMap, MutatedFilesAreReadOrRefused) {
  std::mt19937 random(5);
  for (int round = 0; round < 3000; ++round) {
    std::string text = random() % 2 == 0 ? kSmall : with_crlf(kSmall);
    for (auto edits = random() % 3 + 1; edits > 0 && !text.empty(); --edits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) text[at] = static_cast<char>(random() % 256);
      if (random() % 3 == 0) text.erase(at, random() % 20);
      if (random() % 3 == 0) text.insert(std::min(at, text.size()), "9\n");
    }
    const Reading read(text);
    if (!read.grid) continue;
    EXPECT_EQ(read.grid->blocked.size(), read.grid->index(0, read.grid->rows)) << text;
  }
}

TEST(GridMap, BenchmarkMaps) {
  ALATE_NEEDS_SHARED_DATA("movingai/2d");
  struct Known {
    const char* name;
    int columns;
    int rows;
    std::ptrdiff_t free;
  };
  for (const Known& map :
       {Known{"arena", 49, 49, 2054}, Known{"den312d", 65, 81, 2445}, Known{"lak303d", 194, 194, 14784},
        Known{"Boston_0_256", 256, 256, 47768}, Known{"brc202d", 530, 481, 43151}}) {
    std::vector<Fault> faults;
    const auto grid = read_grid_map(test::shared_data(fmt::format("movingai/2d/{}.map", map.name)).string(), faults);
    ASSERT_TRUE(grid) << map.name << (faults.empty() ? "" : to_string(faults.front()));
    EXPECT_EQ(grid->columns, map.columns);
    EXPECT_EQ(grid->rows, map.rows);
    EXPECT_EQ(std::ranges::count(grid->blocked, 0), map.free) << map.name;
  }
}

}  // namespace
}  // namespace alate
