#include <gtest/gtest.h>

#include "alate/data/site.hpp"
#include "data/scenario_samples.hpp"

namespace alate {
namespace {

using test::faults_in;
using test::kGridScenario;

std::string all_faults(const std::string& text) {
  std::string all;
  for (const Fault& fault : faults_in(text)) all += to_string(fault) + "\n";
  return all;
}

std::string site_faults(const std::string& text) {
  try {
    load_site(parse_scenario(text, "s.yaml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SiteGrid, RandomGridWithHeights) {
  const Site site = load_site(parse_scenario(kGridScenario, "s.yaml"));
  ASSERT_TRUE(site.grid);
  EXPECT_TRUE(site.frame.is_local());
  EXPECT_FALSE(site.has_ground());
  EXPECT_EQ(site.grid->blocked.size(), 600U);
  EXPECT_EQ(site.grid->height_m.size(), 600U);
  EXPECT_EQ(site.mission.start, Vec3(5, 5, 0));
  EXPECT_EQ(site.mission.goal, Vec3(295, 195, 0));
  EXPECT_EQ(site.grid->area().max, Vec2(300, 200));
}

TEST(SiteGrid, EndsOutsideOrBlocked) {
  EXPECT_NE(site_faults(test::with(kGridScenario, "[29, 0]", "[30, 0]"))
                .find("s.yaml:3:14: goal.cell: lies outside the grid (got [30, 0], allowed [0, 0] to [29, 19])"),
            std::string::npos);
}

TEST(SiteGrid, UnreadableMapIsAFaultOfItsKey) {
  const std::string text =
      test::with(kGridScenario, "random: {size: [30, 20], obstacles: 0.3, seed: 4}", "map: /nowhere/x.map");
  EXPECT_NE(site_faults(text).find("s.yaml:1:13: grid.map: /nowhere/x.map: no such file"), std::string::npos)
      << site_faults(text);
}

TEST(SiteGrid, WhatCannotStandBesideAGrid) {
  EXPECT_EQ(all_faults(test::with(kGridScenario, "start: {cell: [0, 19]}", "start: {position_m: [0, 0, 0]}")),
            "s.yaml:2:1: start: must be a cell of the grid (allowed {cell: [column, row]})\n");
  EXPECT_EQ(all_faults("frame: {local: true}\nstart: {cell: [1, 1]}\ngoal: {position_m: [0, 0, 0]}\n"),
            "s.yaml:2:15: start.cell: needs a grid\n");
  EXPECT_EQ(all_faults(kGridScenario + "terrain: {dem: x.tif}\nframe: {crs: \"EPSG:32616\"}\n"),
            "s.yaml:4:1: terrain: cannot stand beside a grid\ns.yaml:5:14: frame.crs: a grid lies in a local frame\n");
}

TEST(SiteGrid, Numbers) {
  EXPECT_EQ(all_faults(test::with(kGridScenario, "[30, 20]", "[30.5, 0]")),
            "s.yaml:1:24: grid.random.size.0: must be a whole number (got 30.5)\n"
            "s.yaml:1:30: grid.random.size.1: out of range (got 0, allowed 1 to 10000 cells)\n");
  EXPECT_EQ(all_faults(test::with(kGridScenario, "[30, 20]", "[9000, 9000]")),
            "s.yaml:1:23: grid.random.size: too large (got 81000000, allowed <= 16000000 cells)\n");
  EXPECT_EQ(all_faults(test::with(kGridScenario, "obstacles: 0.3", "obstacles: 1.3")),
            "s.yaml:1:44: grid.random.obstacles: out of range (got 1.3, allowed 0 to 1)\n");
  EXPECT_EQ(all_faults(test::with(kGridScenario, "heights: peaks", "heights: hills")),
            "s.yaml:1:68: grid.heights: unknown word (got hills, allowed flat | peaks)\n");
}

}  // namespace
}  // namespace alate
