#include "data/scen_file.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace alate {
namespace {

namespace fs = std::filesystem;

const std::string kMap = "type octile\nheight 2\nwidth 3\nmap\n..@\n...\n";

/// A map and its tasks in a folder of their own.
class ScenFileTest : public testing::Test {
 protected:
  ScenFileTest() {
    fs::create_directories(folder_);
    write("m.map", kMap);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::optional<ScenFile> read(const std::string& text, const std::string& name = "m.map.scen") {
    write(name, text);
    faults_.clear();
    auto scen = read_scen_file((folder_ / name).string(), faults_);
    EXPECT_EQ(scen.has_value(), faults_.empty());
    return scen;
  }
  std::string faults_of(const std::string& text, const std::string& name = "m.map.scen") {
    read(text, name);
    std::string all;
    for (Fault& fault : faults_) {
      fault.file = fs::path(fault.file).filename().string();
      all += to_string(fault) + "\n";
    }
    return all;
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     fmt::format("alate_scen_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
  std::vector<Fault> faults_;
};

TEST_F(ScenFileTest, RowsAreReadWithBothKindsOfLineEnds) {
  for (const char* end : {"\n", "\r\n"}) {
    const auto scen =
        read(fmt::format("version 1{0}0\tx/m.map\t3\t2\t0\t1\t1\t0\t1.41421{0}3 x/m.map 3 2 0 0 0 1 1{0}", end));
    ASSERT_TRUE(scen.has_value());
    ASSERT_EQ(scen->rows.size(), 2U);
    EXPECT_EQ(scen->rows[0].start_row, 1);
    EXPECT_EQ(scen->rows[0].goal_column, 1);
    EXPECT_EQ(scen->rows[0].optimum, 1.41421);
    EXPECT_EQ(scen->grid.columns, 3);
  }
}

TEST_F(ScenFileTest, EveryFaultIsToldWithItsLine) {
  EXPECT_EQ(
      faults_of("version 1\n"
                "0\tm.map\t3\t2\t0\t0\t1\n"
                "0\tm.map\t4\t2\t0\t0\t1\t0\t1\n"
                "0\tm.map\t3\t2\t0\t2\t2\t0\t1\n"
                "0\tm.map\t3\t2\t-1\tx\t0.5\t0\tnan\n"
                "0\tn.map\t3\t2\t0\t0\t1\t0\t1\n"),
      "m.map.scen:2: wrong number of columns: bucket, map, width, height, start x and y, goal x and y, length (got "
      "7, allowed 9)\n"
      "m.map.scen:3:9: width: is not that of the map (got 4, allowed 3)\n"
      "m.map.scen:4:15: start y: out of range (got 2, allowed 0 to 1)\n"
      "m.map.scen:4:17: goal x: the cell [2, 0] is blocked (got 2, allowed a free cell)\n"
      "m.map.scen:5:13: start x: out of range (got -1, allowed 0 to 2)\n"
      "m.map.scen:5:16: start y: must be a number (got x, allowed 0 to 1)\n"
      "m.map.scen:5:18: goal x: must be a whole number (got 0.5, allowed 0 to 2)\n"
      "m.map.scen:5:24: optimal length: must be finite (got nan, allowed 0 to 1000000000)\n"
      "m.map.scen:6:3: map: all rows must be of one map (got n.map, allowed m.map)\n");
}

TEST_F(ScenFileTest, WhatIsNoListOfTasksIsRefused) {
  EXPECT_EQ(faults_of(""), "m.map.scen: the file is empty\n");
  EXPECT_EQ(faults_of("version 2\n"),
            "m.map.scen:1:1: the first line must name a version that can be read (got version 2, allowed version 1)\n");
  EXPECT_EQ(faults_of("version 1\n"), "m.map.scen:1: the file has a version but no rows\n");
  EXPECT_EQ(faults_of(std::string("version 1\n\0", 11)), "m.map.scen: is not a text file\n");
  EXPECT_EQ(
      faults_of("version 1\n0 m.map 3 2 0 0 1 0 1\n", "n.map.scen"),
      "n.map.scen:2:3: map: the rows are of another map than the name of the file says (got m.map, allowed n.map)\n");
  EXPECT_EQ(faults_of("version 1\n0 o.map 3 2 0 0 1 0 1\n", "o.map.scen"), "o.map: no such file\n");
}

TEST_F(ScenFileTest, AnyBytesAreReadOrRefused) {
  const std::string good = "version 1\n0\tm.map\t3\t2\t0\t1\t1\t0\t1.41421\n";
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    std::string text = good;
    for (int change = 0; change < 3; ++change) text[random() % text.size()] = static_cast<char>(random());
    read(text.substr(0, random() % (text.size() + 1)));
  }
}

/// A voxel map and its tasks.
class VoxelScenFileTest : public ScenFileTest {
 protected:
  VoxelScenFileTest() { write("v.3dmap", "voxel 3 2 4\n1 1 1\n"); }
  std::string voxel_faults_of(const std::string& text, const std::string& name = "v.3dmap.3dscen") {
    write(name, text);
    faults_.clear();
    scen_ = read_voxel_scen_file((folder_ / name).string(), faults_);
    EXPECT_EQ(scen_.has_value(), faults_.empty());
    std::string all;
    for (Fault& fault : faults_) {
      fault.file = fs::path(fault.file).filename().string();
      all += to_string(fault) + "\n";
    }
    return all;
  }

  std::optional<VoxelScenFile> scen_;
};

TEST_F(VoxelScenFileTest, RowsAreReadWithBothKindsOfLineEnds) {
  for (const char* end : {"\n", "\r\n"}) {
    EXPECT_EQ(
        voxel_faults_of(fmt::format("version 1{0}v.3dmap{0}0 0 0 2 1 3 3.5 1.014{0}1\t0 0 1 0 0 0 1.000{0}", end)), "");
    ASSERT_EQ(scen_->rows.size(), 2U);
    EXPECT_EQ(scen_->rows[0].goal, (VoxelCell{2, 1, 3}));
    EXPECT_EQ(scen_->rows[0].optimum, 3.5);
    EXPECT_EQ(scen_->voxels.size(), (VoxelCell{3, 2, 4}));
  }
}

TEST_F(VoxelScenFileTest, EveryFaultIsToldWithItsLine) {
  EXPECT_EQ(
      voxel_faults_of("version 1\n"
                      "v.3dmap\n"
                      "0 0 0 2 1 3 3.5\n"
                      "0 0 4 1 1 1 3.5 1\n"
                      "0 x 0.5 0 0 0 nan -1\n"),
      "v.3dmap.3dscen:3: wrong number of columns: start x, y and z, goal x, y and z, length, ratio (got 7, allowed "
      "8)\n"
      "v.3dmap.3dscen:4:5: start z: out of range (got 4, allowed 0 to 3)\n"
      "v.3dmap.3dscen:4:7: goal x: the cell [1, 1, 1] is blocked (got 1, allowed a free cell)\n"
      "v.3dmap.3dscen:5:3: start y: must be a number (got x, allowed 0 to 1)\n"
      "v.3dmap.3dscen:5:5: start z: must be a whole number (got 0.5, allowed 0 to 3)\n"
      "v.3dmap.3dscen:5:15: optimal length: must be finite (got nan, allowed 0 to 1000000000)\n"
      "v.3dmap.3dscen:5:19: ratio: out of range (got -1, allowed 0 to 1000000000)\n");
}

TEST_F(VoxelScenFileTest, TasksOfAnotherMapAreRefused) {
  EXPECT_EQ(voxel_faults_of("version 1\nv.3dmap\n0 0 0 2 1 3 3.5 1\n", "w.3dmap.3dscen"),
            "w.3dmap.3dscen:2:1: map: the rows are of another map than the name of the file says (got v.3dmap, allowed "
            "w.3dmap)\n");
  EXPECT_EQ(voxel_faults_of("version 1\nw.3dmap\n0 0 0 2 1 3 3.5 1\n", "w.3dmap.3dscen"), "w.3dmap: no such file\n");
  EXPECT_EQ(voxel_faults_of("version 1\n"), "v.3dmap.3dscen:1: the file has a version but no rows\n");
  EXPECT_EQ(voxel_faults_of("version 1\nv.3dmap\n"), "v.3dmap.3dscen:2: the file has a version but no rows\n");
  EXPECT_EQ(voxel_faults_of(""), "v.3dmap.3dscen: the file is empty\n");
}

TEST(ScenTolerance, FollowsTheDigitsWritten) {
  EXPECT_DOUBLE_EQ(scen_tolerance(0), 1e-3);
  EXPECT_DOUBLE_EQ(scen_tolerance(999), 1e-3);
  EXPECT_DOUBLE_EQ(scen_tolerance(1000), 5e-3);
}

}  // namespace
}  // namespace alate
