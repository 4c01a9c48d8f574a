#include "data/voxel_map.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "alate/data/scenario_file.hpp"
#include "alate/data/site.hpp"
#include "data/limits.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

const std::string kSmall = "voxel 3 2 4\n0 0 0\n2 1 3\n1 0 2\n1 0 2\n";

/// `text` in a file of its own, read.
struct Reading {
  explicit Reading(const std::string& text) {
    // Tests run side by side.
    const std::string file = fmt::format("{}alate_voxel_{}.3dmap", testing::TempDir(),
                                         testing::UnitTest::GetInstance()->current_test_info()->name());
    std::ofstream(file, std::ios::binary) << text;
    grid = read_voxel_map(file, faults);
    EXPECT_EQ(grid.has_value(), faults.empty());
    for (Fault& fault : faults) {
      EXPECT_EQ(fault.file, file);
      fault.file = "m.3dmap";
    }
  }
  std::string all_faults() const {
    std::string all;
    for (const Fault& fault : faults) all += to_string(fault) + "\n";
    return all;
  }

  std::optional<VoxelGrid> grid;
  std::vector<Fault> faults;
};

std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

TEST(VoxelMap, CellsAndBothKindsOfLineEnds) {
  for (const std::string& text : {kSmall, with_crlf(kSmall), kSmall + "\n \r\n", kSmall.substr(0, kSmall.size() - 1)}) {
    const Reading read(text);
    ASSERT_EQ(read.all_faults(), "");
    EXPECT_EQ(read.grid->size(), (VoxelCell{3, 2, 4}));
    std::vector<VoxelCell> blocked;
    read.grid->for_each_blocked([&](const VoxelCell& cell) { blocked.push_back(cell); });
    EXPECT_EQ(blocked, (std::vector<VoxelCell>{{0, 0, 0}, {1, 0, 2}, {2, 1, 3}}));
  }
}

TEST(VoxelMap, CellsLieInTheFrameAsTheyAreNumbered) {
  VoxelGrid grid({3, 2, 4}, 10);
  EXPECT_EQ(grid.center({2, 0, 3}), Vec3(25, 5, 35));
  EXPECT_EQ(grid.cell_at({25, 5, 35}), (VoxelCell{2, 0, 3}));
  EXPECT_EQ(grid.cell_at({25, 5, 40}), std::nullopt);
  EXPECT_EQ(grid.cell_at({-1, 5, 35}), std::nullopt);
  EXPECT_TRUE(grid.is_free({2, 0, 3}));
  grid.block({2, 0, 3});
  EXPECT_FALSE(grid.is_free({2, 0, 3}));
  EXPECT_FALSE(grid.is_free({2, 0, 4}));
  grid.free({2, 0, 3});
  EXPECT_TRUE(grid.is_free({2, 0, 3}));
}

TEST(VoxelMap, EveryFaultIsToldAtOnceWithItsPlace) {
  EXPECT_EQ(Reading("voxel 3 2 4\n3 0 0\n0 -1 4\n0 0\n1 1 1 1\n1 x 1.5\n 0\t0 99999999999\n").all_faults(),
            "m.3dmap:2:1: x: out of range (got 3, allowed 0 to 2 cells)\n"
            "m.3dmap:3:3: y: out of range (got -1, allowed 0 to 1 cells)\n"
            "m.3dmap:3:6: z: out of range (got 4, allowed 0 to 3 cells)\n"
            "m.3dmap:4:1: too few numbers (got 0 0, allowed x y z)\n"
            "m.3dmap:5:1: words that do not belong here (got 1 1 1 1, allowed x y z)\n"
            "m.3dmap:6:3: y: must be a whole number (got x, allowed 0 to 1 cells)\n"
            "m.3dmap:6:5: z: must be a whole number (got 1.5, allowed 0 to 3 cells)\n"
            "m.3dmap:7:6: z: out of range (got 99999999999, allowed 0 to 3 cells)\n");
  EXPECT_EQ(Reading("voxel 0 2001 x\n").all_faults(),
            "m.3dmap:1:7: x: out of range (got 0, allowed 1 to 2000 cells)\n"
            "m.3dmap:1:9: y: out of range (got 2001, allowed 1 to 2000 cells)\n"
            "m.3dmap:1:14: z: must be a whole number (got x, allowed 1 to 2000 cells)\n");
}

TEST(VoxelMap, WhatIsNoMapIsRefused) {
  EXPECT_EQ(Reading("").all_faults(), "m.3dmap: the file is empty\n");
  EXPECT_EQ(Reading(" \r\n\n").all_faults(), "m.3dmap:2: the file is empty\n");
  EXPECT_EQ(Reading(std::string("voxel 1 1 1\n0\0 0", 16)).all_faults(), "m.3dmap:2:2: is not a text file\n");
  EXPECT_EQ(Reading("type octile\nheight 2\n").all_faults(),
            "m.3dmap:1:1: the first line must be the header of a voxel map (got type octile, allowed voxel X Y Z)\n");
  EXPECT_EQ(Reading("voxel 3 2\n").all_faults(), "m.3dmap:1:1: too few numbers (got voxel 3 2, allowed voxel X Y Z)\n");
  EXPECT_EQ(Reading("voxel 3 2 1 9\n").all_faults(),
            "m.3dmap:1:1: words that do not belong here (got voxel 3 2 1 9, allowed voxel X Y Z)\n");
  EXPECT_EQ(Reading("voxel 2000 2000 2000\n").all_faults(),
            "m.3dmap:1: too many cells (got 8000000000, allowed <= 100000000 cells)\n");
}

TEST(VoxelMap, MissingFileAndFolder) {
  for (const std::string& file : {testing::TempDir() + "alate_no_such.3dmap", testing::TempDir()}) {
    std::vector<Fault> faults;
    EXPECT_FALSE(read_voxel_map(file, faults));
    EXPECT_EQ(faults.size(), 1U);
  }
}

TEST(VoxelMap, ManyFaultsAreCounted) {
  std::string text = "voxel 1 1 1\n";
  for (int i = 0; i < 200; ++i) text += "7 0 0\n";
  const Reading read(text);
  ASSERT_EQ(read.faults.size(), kMaxFaults + 1);
  EXPECT_EQ(read.faults.back().message, "and 100 more faults");
}

TEST(VoxelMap, IsKnownByNameOrBeginning) {
  const std::string other = testing::TempDir() + "alate_voxel_by_header.map";
  std::ofstream(other) << kSmall;
  EXPECT_TRUE(is_voxel_map("no_such.3dmap"));
  EXPECT_TRUE(is_voxel_map(other));
  EXPECT_FALSE(is_voxel_map("no_such.map"));
  EXPECT_FALSE(is_voxel_map(testing::TempDir()));
  std::ofstream(other) << "type octile\nheight 1\nwidth 1\nmap\n.\n";
  EXPECT_FALSE(is_voxel_map(other));
}

TEST(VoxelMap, MutatedFilesAreReadOrRefused) {
  std::mt19937 random(5);
  for (int round = 0; round < 1000; ++round) {
    std::string text = random() % 2 == 0 ? kSmall : with_crlf(kSmall);
    for (auto edits = random() % 3 + 1; edits > 0 && !text.empty(); --edits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) text[at] = static_cast<char>(random() % 256);
      if (random() % 3 == 0) text.erase(at, random() % 20);
      if (random() % 3 == 0) text.insert(std::min(at, text.size()), "9\n");
    }
    const Reading read(text);
    if (!read.grid) continue;
    read.grid->for_each_blocked([&](const VoxelCell& cell) { EXPECT_TRUE(read.grid->contains(cell)) << text; });
  }
}

/// A scenario beside a map, and what it is refused for.
class VoxelScenario : public testing::Test {
 protected:
  VoxelScenario() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "m.3dmap") << kSmall;
  }
  Site site_of(const std::string& text) const {
    std::ofstream(folder_ / "s.yaml") << text;
    return load_site(load_scenario((folder_ / "s.yaml").string()));
  }
  std::string faults_of(const std::string& text) const {
    try {
      site_of(text);
    } catch (const InputError& error) {
      std::string all;
      for (Fault fault : error.faults()) {
        fault.file = std::filesystem::path(fault.file).filename().string();
        all += to_string(fault) + "\n";
      }
      return all;
    }
    return "";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      fmt::format("alate_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(VoxelScenario, EndsAreTheMiddlesOfCells) {
  const Site site = site_of("grid: {map: m.3dmap, cell_m: 2}\nstart: {cell: [1, 0, 0]}\ngoal: {cell: [0, 1, 3]}\n");
  ASSERT_TRUE(site.voxels);
  EXPECT_FALSE(site.grid);
  EXPECT_FALSE(site.has_ground());
  EXPECT_TRUE(site.frame.is_local());
  EXPECT_EQ(site.mission.start, Vec3(3, 1, 1));
  EXPECT_EQ(site.mission.goal, Vec3(1, 3, 7));
  EXPECT_EQ(site.scenario.objective.climb, 0);
  EXPECT_EQ(to_yaml(site.scenario).find("cell: [1, 0, 0]") != std::string::npos, true);
}

TEST_F(VoxelScenario, EndsThatAreNoFreeCells) {
  EXPECT_EQ(faults_of("grid: {map: m.3dmap}\nstart: {cell: [0, 0, 0]}\ngoal: {cell: [0, 2, 3]}\n"),
            "s.yaml:2:15: start.cell: is a blocked cell (got [0, 0, 0])\n"
            "s.yaml:3:14: goal.cell: lies outside the map (got [0, 2, 3], allowed [0, 0, 0] to [2, 1, 3])\n");
  EXPECT_EQ(faults_of("grid: {map: m.3dmap}\nstart: {cell: [1, 0]}\ngoal: {cell: [0, 1, 3]}\n"),
            "s.yaml:2:15: start.cell: a cell of a voxel map has three numbers (got [1, 0], allowed [x, y, z])\n");
  EXPECT_EQ(faults_of("grid: {random: {size: [3, 3]}}\nstart: {cell: [1, 0, 0]}\ngoal: {cell: [0, 1]}\n"),
            "s.yaml:2:15: start.cell: a cell of this grid has two numbers (got [1, 0, 0], allowed [column, row])\n");
  EXPECT_EQ(faults_of("grid: {map: m.3dmap, heights: peaks}\nstart: {cell: [1, 0, 0]}\ngoal: {cell: [0, 1, 3]}\n"),
            "s.yaml:1:31: grid.heights: voxels have no heights\n");
  EXPECT_NE(faults_of("grid: {map: m.3dmap}\nstart: {cell: [1, 0, 0, 0]}\ngoal: {cell: [0, 1, 3]}\n"), "");
}

TEST_F(VoxelScenario, FaultsOfTheMapAreTold) {
  std::ofstream(folder_ / "m.3dmap") << "voxel 3 2 4\n9 9 9\n";
  const std::string all = faults_of("grid: {map: m.3dmap}\nstart: {cell: [1, 0, 0]}\ngoal: {cell: [0, 1, 3]}\n");
  for (const char* part : {"m.3dmap:2:1: x", "m.3dmap:2:3: y", "m.3dmap:2:5: z"})
    EXPECT_NE(all.find(part), std::string::npos) << all;
  EXPECT_NE(faults_of("grid: {map: n.3dmap}\nstart: {cell: [1, 0, 0]}\ngoal: {cell: [0, 1, 3]}\n").find("no such file"),
            std::string::npos);
}

TEST(VoxelMap, BenchmarkMaps) {
  ALATE_NEEDS_SHARED_DATA("movingai/3d");
  struct Known {
    const char* name;
    VoxelCell size;
    double share;  ///< Of blocked cells.
  };
  for (const Known& map : {Known{"Simple", {105, 132, 105}, 0.0004}, Known{"Complex", {246, 154, 205}, 0.0060},
                           Known{"DA1", {389, 313, 511}, 0.0023}}) {
    std::vector<Fault> faults;
    const auto grid = read_voxel_map(test::shared_data(fmt::format("movingai/3d/{}.3dmap", map.name)).string(), faults);
    ASSERT_TRUE(grid.has_value());
    EXPECT_EQ(grid->size(), map.size);
    std::size_t blocked = 0;
    grid->for_each_blocked([&](const VoxelCell&) { ++blocked; });
    EXPECT_NEAR(static_cast<double>(blocked) / static_cast<double>(grid->count()), map.share, 0.00005) << map.name;
  }
}

}  // namespace
}  // namespace alate
