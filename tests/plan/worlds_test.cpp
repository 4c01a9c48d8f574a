// Every world of examples/worlds is read, and flown by the interval search.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/height_raster.hpp"
#include "support/fly.hpp"
#include "support/worlds.hpp"

namespace alate {
namespace {

struct WorldAndBand {
  test::FlightWorld world;
  std::string band;
};

std::vector<WorldAndBand> all_worlds() {
  std::vector<WorldAndBand> all;
  for (const test::FlightWorld& world : test::flight_worlds())
    for (const char* band : test::kBandNames) all.push_back({world, band});
  return all;
}

class Worlds : public testing::TestWithParam<WorldAndBand> {};

/// Work is counted, not time, which depends on what else the machine does: so much is a small part of a second.
TEST_P(Worlds, AreFlownWithinASecond) {
  const auto& [world, band] = GetParam();
  if (!world.has_ground()) GTEST_SKIP() << "SKIPPED: needs " << test::shared_data(world.dem);
  const World ground(load_site(test::world_scenario(world, band)));
  EXPECT_EQ(ground.site().threats.size(), 3U);
  const Plan first = test::fly(ground, {.name = "interval-astar"}, {.iterations = 1});
  ASSERT_EQ(first.outcome, Outcome::feasible) << first.why;
  EXPECT_LT(first.counters.at("expansions"), 20'000);
  for (const Violation& broken : check(ground.site(), first.route).violations)
    ADD_FAILURE() << broken.rule << " on leg " << broken.leg << ", " << broken.value << " of " << broken.limit;
  EXPECT_GE(first.cost, first.lower_bound);
}

INSTANTIATE_TEST_SUITE_P(All, Worlds, testing::ValuesIn(all_worlds()),
                         [](const auto& one) { return one.param.world.name + "_" + one.param.band; });

/// The two files of a world differ in the band alone.
TEST_P(Worlds, ShareAllButTheBand) {
  const auto& [world, band] = GetParam();
  Scenario wide = test::world_scenario(world, "wide");
  const Scenario narrow = test::world_scenario(world, "narrow");
  EXPECT_EQ(wide.terrain->clearance_m, 60);
  EXPECT_EQ(wide.terrain->ceiling_agl_m, 400);
  EXPECT_EQ(narrow.terrain->clearance_m, 50);
  EXPECT_EQ(narrow.terrain->ceiling_agl_m, 120);
  wide.terrain = narrow.terrain;
  EXPECT_EQ(wide, narrow);
}

}  // namespace
}  // namespace alate
