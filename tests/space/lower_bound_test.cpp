#include "space/lower_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "space/attitude.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

TEST(LowerBound, NodeBoundIsTheSumOverSteps) {
  for (double distance = 0; distance < 30; distance += 0.37) {
    double sum = 0;
    const int steps = static_cast<int>(std::ceil((distance - 0.5) / 2));
    for (int i = 1; i <= steps; ++i) sum += std::max(0.0, distance - 2 * i);
    EXPECT_NEAR(node_bound(distance, 0.3, 2, 0.5), 0.3 * sum, 1e-12) << distance;
  }
}

TEST(LowerBound, ThePapersCase) {
  const double turn = RotationSet(test::konatowski_site(1, {}).vehicle).largest_turn();
  EXPECT_NEAR(turn_limited_node_bound(test::konatowski_site(1, {}), turn), 132.608, 0.001);
  EXPECT_NEAR(turn_limited_node_bound(test::konatowski_site(0.2, {}), turn), 26.521, 0.001);
  EXPECT_NEAR(turn_limited_node_bound(test::konatowski_site(0.5, {}), turn), 66.304, 0.001);
  EXPECT_NEAR(turn_limited_node_bound(test::konatowski_site(0.8, {}), turn), 106.086, 0.001);
}

TEST(LowerBound, WithoutTurnLimitItIsTheNodeBound) {
  const Site site = test::konatowski_site(1, {});
  const double distance = (site.mission.goal - site.mission.start).norm();
  EXPECT_NEAR(turn_limited_node_bound(site, kPi), node_bound(distance, 1, 2, 2), 1e-3);
  EXPECT_LE(turn_limited_node_bound(site, kPi), node_bound(distance, 1, 2, 2) + 1e-9);
}

TEST(LowerBound, PhysicalCountsSlopeAndAscent) {
  Site site = test::open_air_site();
  site.mission.start = {0, 0, 0};
  site.mission.goal = {1000, 0, 600};
  site.mission.tolerance_m = 100;
  site.vehicle.climb_rad = radians(30);
  // 500 m of ascent take 1000 m of flight at 30 degrees: less than the straight line minus the tolerance.
  EXPECT_NEAR(physical_bound(site, site.mission.start), std::hypot(1000, 600) - 100 + 2 * 500, 1e-9);
  site.vehicle.climb_rad = radians(10);
  EXPECT_NEAR(physical_bound(site, site.mission.start), 500 / std::sin(radians(10)) + 2 * 500, 1e-9);
  EXPECT_NEAR(physical_bound(site, site.mission.goal), 0, 1e-12);
}

/// Cost of a random flight of 30 moves to its first point within the tolerance of its own end, and the bound for
/// that goal. Nothing if the flight breaks a climb limit.
struct Flight {
  bool counts = true;
  double cost = 0;
  double bound = 0;
};

Flight random_flight(Site site, std::uint64_t seed) {
  Stream stream(seed, 0, 0);
  const RotationSet rotations(site.vehicle);
  std::vector<Vec3> nodes{site.mission.start};
  Mat3 attitude = level_attitude(site.mission.heading_rad);
  for (int i = 0; i < 30; ++i) {
    attitude = attitude * rotations.matrix(stream.below(rotations.size()));
    nodes.emplace_back(nodes.back() + *site.vehicle.step_m * attitude.col(0));
  }
  site.mission.goal = nodes.back();
  const World world(site);
  const AttitudeSpace space(world, nullptr);
  Flight flight{.bound = space.problem_bound()};
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if ((nodes[i - 1] - site.mission.goal).norm() <= site.mission.tolerance_m) break;
    const Segment leg{nodes[i - 1], nodes[i]};
    flight.counts &= std::abs(climb_angle(leg)) <= site.vehicle.climb_rad.value_or(kPi);
    flight.cost += space.objective().leg_cost(leg);
  }
  return flight;
}

TEST(LowerBound, HoldsOnRandomFlights) {
  Site steep = test::open_air_site();
  steep.vehicle.climb_rad = steep.vehicle.descent_rad = radians(25);
  for (const Site& site : {steep, test::konatowski_site(0.5, test::kLayoutA)}) {
    int counted = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
      const Flight flight = random_flight(site, seed);
      if (!flight.counts) continue;
      EXPECT_GE(flight.cost, flight.bound - 1e-9) << seed;
      ++counted;
    }
    EXPECT_GT(counted, 20);
  }
}

}  // namespace
}  // namespace alate
