#include "data/points_file.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "data/limits.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

const std::string kHeader = "id,x_m,y_m,z_m,kind,may_fail\n";

/// `text` in a file of its own, read.
struct Reading {
  explicit Reading(const std::string& text, double success = 0.8) {
    // Tests run side by side.
    const std::string file = fmt::format("{}alate_points_{}.csv", testing::TempDir(),
                                         testing::UnitTest::GetInstance()->current_test_info()->name());
    std::ofstream(file, std::ios::binary) << text;
    given = read_points_file(file, success, faults);
    for (Fault& fault : faults) {
      EXPECT_EQ(fault.file, file);
      fault.file = "p.csv";
    }
  }
  std::string all_faults() const {
    std::string all;
    for (const Fault& fault : faults) all += to_string(fault) + "\n";
    return all;
  }

  GivenPoints given;
  std::vector<Fault> faults;
};

TEST(PointsFile, ColumnsStandInAnyOrder) {
  const Reading read(
      "kind,z_m,id,may_fail,x_m,y_m\r\nvertical,3,12,1,1.5,-2\r\n\r\n\"horizontal\", 4 ,13,0,1e3,.5\r\n");
  ASSERT_EQ(read.all_faults(), "");
  ASSERT_EQ(read.given.points().size(), 2U);
  const GivenPoint& first = read.given.points()[0];
  EXPECT_EQ(first.point.id, 12);
  EXPECT_EQ(first.point.position, Vec3(1.5, -2, 3));
  EXPECT_EQ(first.point.kind, PointKind::vertical);
  EXPECT_EQ(first.point.success, 0.8);
  EXPECT_FALSE(first.geographic);
  const GivenPoint& second = read.given.points()[1];
  EXPECT_EQ(second.point.position, Vec3(1000, 0.5, 4));
  EXPECT_EQ(second.point.kind, PointKind::horizontal);
  EXPECT_EQ(second.point.success, 1);
  EXPECT_EQ(second.row, 4);
}

TEST(PointsFile, EndsStandApart) {
  const Reading read(kHeader + "0,1,2,3,start,0\n5,1,1,1,vertical,0\n9,7,8,9,end,0");
  EXPECT_EQ(read.all_faults(), "");
  EXPECT_EQ(read.given.points().size(), 1U);
  EXPECT_EQ(read.given.start()->point.position, Vec3(1, 2, 3));
  EXPECT_EQ(read.given.end()->point.id, 9);
}

TEST(PointsFile, PlacesOnEarthAndChancesOfTheirOwn) {
  const Reading read(
      "id,lat,lon,amsl_m,kind,may_fail,success\n1,47.5,-8,300,vertical,1,0.25\n2,47,8,300,vertical,1,\n"
      "3,47,8,300,vertical,0,1\n",
      0.6);
  ASSERT_EQ(read.all_faults(), "");
  EXPECT_TRUE(read.given.points()[0].geographic);
  EXPECT_EQ(read.given.points()[0].point.position, Vec3(47.5, -8, 300));
  EXPECT_EQ(read.given.points()[0].point.success, 0.25);
  EXPECT_EQ(read.given.points()[1].point.success, 0.6);
  EXPECT_EQ(read.given.points()[2].point.success, 1);
}

TEST(PointsFile, EveryFaultIsToldAtOnceWithItsPlace) {
  const Reading read(
      "id,x_m,y_m,z_m,kind,may_fail,success\n"
      "1,0,0,0,start,0,\n"
      "2,nan,0,0,vertical,0,\n"
      "3,0,1e300,-inf,vertical,0,\n"
      "3.5,0,0,x,sideways,2,\n"
      "-4,0,0,0,vertical,1,1.5\n"
      "5,0,0,0,vertical,0\n"
      "1,0,0,0,vertical,0,0.5\n"
      "1,0,0,0,vertical,0,\n"
      "7,0,0,0,start,0,\n");
  EXPECT_EQ(read.all_faults(),
            "p.csv:3:3: x_m: must be finite (got nan, allowed -1000000000 to 1000000000)\n"
            "p.csv:4:5: y_m: out of range (got 1e300, allowed -1000000000 to 1000000000)\n"
            "p.csv:4:11: z_m: must be finite (got -inf, allowed -1000000000 to 1000000000)\n"
            "p.csv:5:1: id: must be a whole number (got 3.5)\n"
            "p.csv:5:9: z_m: must be a number (got x, allowed -1000000000 to 1000000000)\n"
            "p.csv:5:11: kind: unknown word (got sideways, allowed start | end | vertical | horizontal)\n"
            "p.csv:5:20: may_fail: must be 0 or 1 (got 2, allowed 0 | 1)\n"
            "p.csv:6:1: id: out of range (got -4, allowed 0 to 99999999)\n"
            "p.csv:6:21: success: out of range (got 1.5, allowed 0 to 1)\n"
            "p.csv:7: wrong number of columns (got 6, allowed 7)\n"
            "p.csv:8:20: success: must be 1 or nothing where may_fail is 0 (got 0.5, allowed 1)\n"
            "p.csv:8:1: id: another point has this id (got 1)\n"
            "p.csv:9:1: id: another point has this id (got 1)\n"
            "p.csv:10:9: kind: point 1 is that already (got start, allowed one start)\n"
            "p.csv: kind: the points have a start but no end (allowed one start and one end, or neither)\n");
}

TEST(PointsFile, HeadersAreJudged) {
  EXPECT_EQ(Reading("id,x_m,y_m,kinds,may_fail,id\n").all_faults(),
            "p.csv:1:12: unknown column; did you mean kind? (got kinds)\n"
            "p.csv:1:27: id: the column is given twice\n"
            "p.csv:1: z_m: the column is missing\np.csv:1: kind: the column is missing\n");
  EXPECT_EQ(Reading("id,x_m,y_m,z_m,lat,lon,amsl_m,kind,may_fail\n").all_faults(),
            "p.csv:1: the places need exactly one of these sets of columns (allowed x_m, y_m, z_m | lat, lon, "
            "amsl_m)\n");
}

TEST(PointsFile, WhatIsNoTableIsRefused) {
  EXPECT_EQ(Reading("").all_faults(), "p.csv: the file is empty\n");
  EXPECT_EQ(Reading(" \n\r\n").all_faults(), "p.csv: the file is empty\n");
  EXPECT_EQ(Reading(kHeader).all_faults(), "p.csv: the file has a header but no points\n");
  EXPECT_EQ(Reading(std::string("id\0,x", 5)).all_faults(), "p.csv: is not a text file\n");
  EXPECT_NE(Reading("{\"points\": []}").all_faults().find("the column is missing"), std::string::npos);
}

TEST(PointsFile, OneEndNeedsTheOther) {
  EXPECT_EQ(Reading(kHeader + "0,0,0,0,start,0\n1,0,0,0,vertical,0\n").all_faults(),
            "p.csv: kind: the points have a start but no end (allowed one start and one end, or neither)\n");
  EXPECT_EQ(Reading(kHeader + "0,0,0,0,end,0\n1,0,0,0,vertical,0\n").all_faults(),
            "p.csv: kind: the points have an end but no start (allowed one start and one end, or neither)\n");
}

TEST(PointsFile, TooManyPointsAreRefused) {
  std::string text = kHeader;
  for (std::size_t i = 0; i <= kMaxPoints; ++i) fmt::format_to(std::back_inserter(text), "{},0,0,0,vertical,0\n", i);
  EXPECT_EQ(Reading(text).all_faults(), "p.csv:4000002: too many points (allowed <= 4000000)\n");
}

TEST(PointsFile, ManyFaultsAreCounted) {
  std::string text = kHeader;
  for (int i = 0; i < 5000; ++i) text += "1,0,0,0,vertical,0\n";
  const Reading read(text);
  ASSERT_EQ(read.faults.size(), kMaxFaults + 1);
  EXPECT_EQ(read.faults.back().message, "and 4899 more faults");
}

TEST(PointsFile, MutatedFilesAreReadOrRefused) {
  std::string text = kHeader;
  for (int i = 0; i < 10; ++i)
    text += fmt::format("{},{},5.25,-1e3,{},{}\n", i, i * 100.5, i % 2 == 0 ? "horizontal" : "vertical", i % 2);
  std::mt19937 random(3);
  for (int round = 0; round < 3000; ++round) {
    std::string edited = text;
    for (unsigned edits = random() % 4 + 1; edits > 0; --edits) {
      const std::size_t at = random() % edited.size();
      if (random() % 2 == 0) edited[at] = static_cast<char>(random() % 256);
      if (random() % 3 == 0) edited.erase(at, random() % 30);
      if (random() % 3 == 0) edited.insert(std::min(at, edited.size()), ",\"");
    }
    const Reading read(edited);
    EXPECT_EQ(read.faults.empty() && read.given.points().empty(), false) << edited;
    for (const GivenPoint& each : read.given.points()) EXPECT_TRUE(each.point.position.allFinite());
  }
}

TEST(PointsFile, ContestSets) {
  ALATE_NEEDS_SHARED_DATA("correction-points/set1.csv");
  std::vector<Fault> faults;
  const GivenPoints set = read_points_file(test::shared_data("correction-points/set1.csv").string(), 0.8, faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(set.points().size(), 611U);
  EXPECT_EQ(std::ranges::count(set.points(), 0.8, [](const GivenPoint& each) { return each.point.success; }), 148);
  EXPECT_NEAR((set.start()->point.position - set.end()->point.position).norm(), 100'464.76, 0.01);
}

}  // namespace
}  // namespace alate
