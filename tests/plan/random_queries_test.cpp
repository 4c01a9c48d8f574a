// Flights between random places: whatever is found keeps every rule. bench/random_queries.cpp asks thousands.
#include "support/random_queries.hpp"

#include <gtest/gtest.h>

#include "support/worlds.hpp"

namespace alate {
namespace {

class RandomQueries : public testing::TestWithParam<const char*> {};

TEST_P(RandomQueries, AreAnsweredWithRoutesThatPass) {
  constexpr std::uint64_t kQueries = 8;
  int solved = 0;
  for (const char* band : test::kBandNames) {
    const World world(load_site(test::world_scenario({.name = GetParam(), .dem = ""}, band)));
    for (std::uint64_t i = 0; i < kQueries; ++i) {
      const auto mission = test::draw_mission(world, Stream(1, 0, i));
      ASSERT_TRUE(mission);
      const test::Answer answer = test::fly_query(world.site(), *mission, {.iterations = 3, .time_limit_s = 0.5});
      EXPECT_EQ(answer.fault, "") << test::command_for(world.site(), *mission,
                                                       std::string(GetParam()) + "-" + band + ".yaml");
      solved += answer.solved() ? 1 : 0;
    }
  }
  EXPECT_GT(solved, 0);
}

INSTANTIATE_TEST_SUITE_P(All, RandomQueries, testing::Values("jacksboro", "canyon", "lowceiling"),
                         [](const auto& one) { return one.param; });

/// The drawn places are in the band, and the same seed draws the same.
TEST(RandomQueries, AreDrawnFarApartAndInTheBand) {
  const World world(load_site(test::world_scenario({.name = "canyon", .dem = ""}, "narrow")));
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto mission = test::draw_mission(world, Stream(2, 0, i));
    const auto again = test::draw_mission(world, Stream(2, 0, i));
    ASSERT_TRUE(mission && again);
    EXPECT_EQ(mission->start, again->start);
    EXPECT_EQ(mission->goal, again->goal);
    EXPECT_GT((mission->goal - mission->start).head<2>().norm(), 0.3 * std::hypot(6000, 6000));
    for (const Vec3& end : {mission->start, mission->goal}) EXPECT_TRUE(world.is_free({end, end}));
  }
}

}  // namespace
}  // namespace alate
