#include "space/turning_flight.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "space/fly_leg.hpp"

namespace alate::test {
namespace {

/// A way that wanders ahead, points at least 700 m apart.
std::vector<Vec3> random_way(std::uint64_t seed, std::size_t count) {
  Stream random(seed, 5, 1);
  std::vector<Vec3> points{1000 * random_unit(random)};
  for (std::size_t i = 1; i < count; ++i)
    points.emplace_back(points.back() + Vec3(2500, 0, 0) + (300 + 1500 * random.uniform()) * random_unit(random));
  return points;
}

TurnRule rule_of(TurnModel model, std::optional<Vec3> heading = {}) {
  return {.model = model, .radius_m = kRadius, .heading = std::move(heading)};
}

/// Flies all legs, each from the heading at the end of the one before.
void expect_flies_all(const std::vector<Vec3>& points, const TurningFlight& flight) {
  ASSERT_EQ(flight.legs.size() + 1, points.size());
  double length = 0;
  Vec3 heading = (points[1] - points[0]).normalized();
  for (std::size_t i = 0; i < flight.legs.size(); ++i) {
    const TurningLeg& leg = flight.legs[i];
    if (i == 0 && leg.leave.angle_rad == 0) {
      const Vec3 end = position_on(leg.arrive, points[1], -leg.arrive.angle_rad);
      heading = (end - points[0]).normalized();
    }
    expect_flies({points[i], heading}, leg, points[i + 1]);
    heading = leg.heading;
    length += leg.length_m;
  }
  EXPECT_NEAR(flight.length_m, length, 1e-9);
}

TEST(TurningFlight, FliesSmoothlyOverAllPointsInEitherModel) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Vec3> points = random_way(seed, 8);
    for (const TurnModel model : {TurnModel::arc_tangent, TurnModel::free_heading}) {
      const TurningFlight flight = fly_over(points, rule_of(model));
      expect_flies_all(points, flight);
      EXPECT_EQ(flight.legs[0].leave.angle_rad, 0);
    }
  }
}

TEST(TurningFlight, FreeHeadingsAreNeverLonger) {
  int shorter = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Stream random(seed, 6, 1);
    std::vector<Vec3> points{Vec3::Zero()};
    for (int i = 0; i < 6; ++i) points.emplace_back(points.back() + 2000 * random.uniform() * random_unit(random));
    const TurningFlight contest = fly_over(points, rule_of(TurnModel::arc_tangent));
    const TurningFlight free = fly_over(points, rule_of(TurnModel::free_heading));
    if (contest.legs.size() < 6) continue;
    ASSERT_EQ(free.legs.size(), 6U);
    EXPECT_LE(free.length_m, contest.length_m);
    shorter += free.length_m < contest.length_m - 1 ? 1 : 0;
  }
  EXPECT_GT(shorter, 50);
}

/// Sum of the legs with `heading` at point `i` instead.
double length_with(const std::vector<Vec3>& points, const TurningFlight& flight, std::size_t i, const Vec3& heading) {
  const auto before = free_heading_leg({points[i - 1], flight.legs[i - 2].heading}, {points[i], heading}, kRadius);
  const auto after = free_heading_leg({points[i], heading}, {points[i + 1], flight.legs[i].heading}, kRadius);
  return before.value().length_m + after.value().length_m;
}

TEST(TurningFlight, NoHeadingNearByIsShorter) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Stream random(seed, 7, 1);
    const std::vector<Vec3> points = random_way(seed, 7);
    const TurningFlight flight = fly_over(points, rule_of(TurnModel::free_heading));
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
      const double own = flight.legs[i - 1].length_m + flight.legs[i].length_m;
      EXPECT_NEAR(length_with(points, flight, i, flight.legs[i - 1].heading), own, 1e-7);
      for (const double step : {1e-4, 1e-3, 1e-2, 0.1}) {
        const Vec3 other = (flight.legs[i - 1].heading + step * random_unit(random)).normalized();
        EXPECT_GE(length_with(points, flight, i, other), own - 1e-8) << seed << " " << i << " " << step;
      }
      // Equal arcs in one plane.
      EXPECT_NEAR(flight.legs[i - 1].arrive.angle_rad, flight.legs[i].leave.angle_rad, 1e-6);
      EXPECT_LT((flight.legs[i - 1].arrive.normal - flight.legs[i].leave.normal).norm(), 1e-6);
    }
  }
}

TEST(TurningFlight, BeginsWithTheGivenHeading) {
  const std::vector<Vec3> points{{0, 0, 0}, {3000, 0, 0}, {6000, 500, 0}};
  for (const TurnModel model : {TurnModel::arc_tangent, TurnModel::free_heading}) {
    const TurningFlight flight = fly_over(points, rule_of(model, Vec3::UnitY()));
    ASSERT_EQ(flight.legs.size(), 2U);
    EXPECT_GT(flight.legs[0].leave.angle_rad, 1.5);
    expect_flies({points[0], Vec3::UnitY()}, flight.legs[0], points[1]);
  }
}

TEST(TurningFlight, StopsBeforeTheLegThatCannotBeFlown) {
  const std::vector<Vec3> points{{0, 0, 0}, {3000, 0, 0}, {3000, 300, 0}, {6000, 0, 0}};
  EXPECT_EQ(fly_over(points, rule_of(TurnModel::arc_tangent)).legs.size(), 1U);
  EXPECT_EQ(fly_over(points, rule_of(TurnModel::none)).legs.size(), 3U);
}

TEST(TurningFlight, StraightBackTakesALoop) {
  const std::vector<Vec3> points{{0, 0, 0}, {3000, 0, 0}, {0, 0, 0}};
  for (const TurnModel model : {TurnModel::arc_tangent, TurnModel::free_heading})
    expect_flies_all(points, fly_over(points, rule_of(model)));
}

}  // namespace
}  // namespace alate::test
