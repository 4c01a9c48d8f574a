// Routes among voxels: which legs touch blocked cells.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "check/example.hpp"
#include "support/voxel_sites.hpp"

namespace alate::test {
namespace {

/// A map of 4 x 4 x 4 cells with some blocked.
Site site_of(const std::vector<VoxelCell>& blocked, double cell_m = 1) {
  Site site;
  site.voxels = VoxelGrid({4, 4, 4}, cell_m);
  for (const VoxelCell& cell : blocked) site.voxels->block(cell);
  return site;
}

/// Through places counted in cells: middles are whole numbers, sides lie half way between.
Route through(Site& site, const std::vector<std::array<double, 3>>& places) {
  std::vector<Vec3> positions;
  for (const auto& [x, y, z] : places) positions.emplace_back(Vec3(x + 0.5, y + 0.5, z + 0.5) * site.voxels->cell_m);
  site.mission.start = positions.front();
  site.mission.goal = positions.back();
  site.mission.tolerance_m = 1e-6;
  return make_route(positions);
}

struct Case {
  std::string name;
  std::vector<std::array<double, 3>> places;
  std::set<std::string> broken;
  std::set<std::size_t> legs;
};

void PrintTo(const Case& route, std::ostream* out) { *out << route.name; }

/// Among cells [1, 1, 1] and [2, 2, 1], which touch along an edge, and [2, 1, 2], which touches the others at edges.
const std::vector<VoxelCell> kBlocked{{1, 1, 1}, {2, 2, 1}, {2, 1, 2}};

const std::vector<Case> kCases{
    {"Above", {{0, 1, 1}, {0, 1, 3}, {3, 1, 3}, {3, 1, 1}}, {}, {}},
    {"Through", {{0, 1, 1}, {3, 1, 1}}, {"terrain_clearance"}, {1}},
    {"UpThrough", {{0, 1, 0}, {1, 1, 0}, {1, 1, 3}}, {"terrain_clearance"}, {2}},
    {"AcrossAnEdgeInTheOpen", {{0, 0, 0}, {1, 1, 0}}, {}, {}},
    {"AcrossACornerInTheOpen", {{2, 2, 2}, {3, 3, 3}}, {}, {}},
    {"AcrossAnEdgeOfOne", {{0, 1, 1}, {1, 0, 1}}, {"terrain_clearance"}, {1}},
    {"AcrossAnEdgeOfTwo", {{1, 2, 1}, {2, 1, 1}}, {"terrain_clearance"}, {1}},
    {"AcrossACornerOfOne", {{0, 0, 1}, {1, 1, 2}}, {"terrain_clearance"}, {1}},
    {"AcrossACornerOfOneInTheMiddleOfAnEdge", {{0, 1, 1}, {1, 1, 2}}, {"terrain_clearance"}, {1}},
    {"AlongAFace", {{0, 1, 1.5}, {1, 1, 1.5}}, {}, {}},
    {"AlongAnEdge", {{1.5, 1.5, 0}, {1.5, 1.5, 1}}, {}, {}},
    {"EdgeHiddenInAJoint", {{1, 2, 1}, {1.5, 1.5, 1}, {2, 1, 1}}, {"terrain_clearance"}, {2}},
    {"AnyAngleThatMisses", {{0, 0, 0}, {3, 1, 0.4}}, {}, {}},
    {"AnyAngleThatClips", {{0, 1, 0.2}, {3, 1, 1.4}}, {"terrain_clearance"}, {1}},
    {"OutOfTheTop", {{0, 0, 0}, {0, 0, 5}, {0, 0, 3}}, {"bounds"}, {1, 2}},
    {"BelowTheFloor", {{0, 0, 0}, {1, 0, -1}, {1, 0, 0}}, {"bounds"}, {1, 2}},
    {"AlongTheFloor", {{0, 0, -0.5}, {3, 0, -0.5}}, {}, {}},
};

class VoxelRoute : public testing::TestWithParam<Case> {};

TEST_P(VoxelRoute, BreaksItsRuleAndNoOther) {
  for (const double cell_m : {1.0, 0.1, 7.3}) {
    Site site = site_of(kBlocked, cell_m);
    const Verdict verdict = check(site, through(site, GetParam().places));
    EXPECT_EQ(broken_rules(verdict), GetParam().broken) << cell_m;
    EXPECT_EQ(broken_legs(verdict), GetParam().legs) << cell_m;
    ASSERT_NE(find_margin(verdict, "terrain_clearance"), nullptr);
    ASSERT_NE(find_margin(verdict, "bounds"), nullptr);
  }
}

TEST_P(VoxelRoute, BackwardsTheSame) {
  Site site = site_of(kBlocked);
  std::vector<std::array<double, 3>> places = GetParam().places;
  std::ranges::reverse(places);
  EXPECT_EQ(broken_rules(check(site, through(site, places))), GetParam().broken);
}

INSTANTIATE_TEST_SUITE_P(Each, VoxelRoute, testing::ValuesIn(kCases),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(Voxels, StandingStill) {
  Site site = site_of(kBlocked);
  EXPECT_TRUE(check(site, through(site, {{0, 0, 0}})).ok());
  EXPECT_EQ(broken_rules(check(site, through(site, {{1, 1, 1}}))), std::set<std::string>{"terrain_clearance"});
  EXPECT_EQ(broken_rules(check(site, through(site, {{9, 9, 9}}))), std::set<std::string>{"bounds"});
}

TEST(Voxels, AlongWhatAllCellsBesideItBlock) {
  Site site = site_of({{1, 1, 1}, {1, 1, 2}});
  EXPECT_EQ(broken_rules(check(site, through(site, {{0, 1, 1.5}, {2, 1, 1.5}}))),
            std::set<std::string>{"terrain_clearance"});
  site = site_of({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_TRUE(check(site, through(site, {{0.5, 0.5, 0.8}, {0.5, 0.5, 1.2}})).ok());
  site.voxels->block({1, 1, 1});
  EXPECT_FALSE(check(site, through(site, {{0.5, 0.5, 0.8}, {0.5, 0.5, 1.2}})).ok());
}

/// The step rule of the benchmark, for each direction and every set of blocked cells in the box that it spans.
TEST(Voxels, StepsFromMiddleToMiddleAreFreeAsTheBenchmarkSays) {
  for (int i = 0; i < 27; ++i) {
    const VoxelCell step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    if (step == VoxelCell{}) continue;
    for (unsigned set = 0; set < 256; ++set) {
      Site site = site_of({});
      for (unsigned corner = 0; corner < 8; ++corner) {
        const auto at = [&](unsigned axis) { return 1 + (((corner >> axis) & 1U) != 0 ? step.at(axis) : 0); };
        if (((set >> corner) & 1U) != 0) site.voxels->block({at(0), at(1), at(2)});
      }
      const Route route = through(site, {{1, 1, 1}, {1.0 + step[0], 1.0 + step[1], 1.0 + step[2]}});
      ASSERT_EQ(check(site, route).ok(), is_free_step(*site.voxels, {1, 1, 1}, step)) << i << " " << set;
    }
  }
}

TEST(Voxels, AgreesWithSamplesOnRandomLegs) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> within(0, 4);
  std::size_t broken = 0;
  for (int round = 0; round < 2000; ++round) {
    Site site = voxel_site(drawn_voxels({4, 4, 4}, 12, random));
    const auto place = [&] { return Vec3(within(random), within(random), within(random)); };
    const Segment leg{place(), place()};
    const auto near_blocked = [&](const Vec3& at, double slack) {
      for (unsigned corner = 0; corner < 8; ++corner) {
        Vec3 beside = at;
        for (int axis = 0; axis < 3; ++axis) beside[axis] += ((corner >> axis) & 1U) != 0 ? slack : -slack;
        const auto cell = site.voxels->cell_at(beside);
        if (cell && site.voxels->blocked_at(*cell)) return true;
      }
      return false;
    };
    bool enters = false;
    bool comes_near = false;
    for (int i = 0; i <= 2000; ++i) {
      const Vec3 at = leg.at(i / 2000.0);
      enters = enters || near_blocked(at, 0);
      comes_near = comes_near || near_blocked(at, 0.01);
    }
    const bool found = broken_rules(check(site, make_route({leg.a, leg.b}))).contains("terrain_clearance");
    broken += found ? 1 : 0;
    EXPECT_TRUE(found || !enters) << round;
    EXPECT_TRUE(comes_near || !found) << round;
  }
  EXPECT_GT(broken, 300U);
  EXPECT_LT(broken, 1700U);
}

TEST(Voxels, FarAwayEndsSoon) {
  Site site = site_of(kBlocked);
  const Route route = through(site, {{0, 0, 0}, {9e7, 9e7, 9e7}, {-9e7, 5, 1}, {0, 0, 0}});
  EXPECT_TRUE(broken_rules(check(site, route)).contains("bounds"));
}

}  // namespace
}  // namespace alate::test
