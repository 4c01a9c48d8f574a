// Arcs in tilted planes: measured as they are flown, and broken in every way.
#include "check/tilted_arc.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "alate/core/stream.hpp"
#include "check/example.hpp"
#include "check/exposure.hpp"
#include "check/leg_shape.hpp"

namespace alate::test {
namespace {

constexpr double kRadius = 200;

Vec3 random_unit(Stream& random) {
  const Vec3 any{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
  return any.normalized();
}

/// 1000 m straight from (0, 0, 1000), a turn in the plane of `heading` and `side`, 1000 m straight.
Route turning_route(const Vec3& heading, const Vec3& side, double angle) {
  const Vec3 start{0, 0, 1000};
  const Vec3 begin = start + 1000 * heading;
  const Vec3 center = begin + kRadius * side;
  const Vec3 end = center + kRadius * (std::sin(angle) * heading - std::cos(angle) * side);
  Route route = make_route({start, begin, end, end + 1000 * (std::cos(angle) * heading + std::sin(angle) * side)});
  route.states[2].leg = LegKind::arc;
  route.states[2].arc = Arc{.center = center.head<2>(),
                            .radius_m = kRadius,
                            .angle_rad = angle,
                            .plane = ArcPlane{.center_z_m = center.z(), .normal = heading.cross(side)}};
  return route;
}

/// A turn of 80 degrees to the right and upwards, in a plane tilted by 50 degrees.
Route example_turn() {
  return turning_route(Vec3::UnitX(), {0, -std::cos(radians(50)), std::sin(radians(50))}, radians(80));
}

Site turning_site(const Route& route) {
  Site site;
  site.mission = {.start = route.states.front().position, .goal = route.states.back().position, .tolerance_m = 50};
  site.navigation = Navigation{.theta = 1, .turn_model = TurnModel::arc_tangent, .turn_radius_m = kRadius};
  return site;
}

TEST(TiltedArc, PassesWithItsOwnRadius) {
  const Route route = example_turn();
  const Verdict verdict = check(turning_site(route), route);
  EXPECT_TRUE(verdict.ok());
  EXPECT_NEAR(find_margin(verdict, "turn")->margin, 0, 1e-9);
}

TEST(TiltedArc, MeasuresWhatIsFlown) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Stream random(seed, 1, 1);
    const Vec3 heading = random_unit(random);
    const Vec3 side = heading.cross(random_unit(random)).normalized();
    const double angle = 2 * kPi * random.uniform();
    const Route route = turning_route(heading, side, angle);
    ASSERT_LT(arc_gap(route, 2), 1e-9);
    EXPECT_NEAR(length_of_leg(route, 2), kRadius * angle, 1e-9);
    EXPECT_LT(angle_between(first_direction(route, 2), heading), 1e-7);
    EXPECT_LT(angle_between(last_direction(route, 2), route.segment(3).b - route.segment(3).a), 1e-7);

    constexpr int kPieces = 20000;
    double up = 0, down = 0, steepest = -kPi, deepest = -kPi;
    for (int k = 0; k < kPieces; ++k) {
      const Segment piece{point_on_leg(route, 2, static_cast<double>(k) / kPieces),
                          point_on_leg(route, 2, static_cast<double>(k + 1) / kPieces)};
      EXPECT_NEAR((piece.a - (route.segment(2).a + kRadius * side)).norm(), kRadius, 1e-9);
      const double rise = piece.b.z() - piece.a.z();
      (rise > 0 ? up : down) += std::abs(rise);
      steepest = std::max(steepest, climb_angle(piece));
      deepest = std::max(deepest, -climb_angle(piece));
    }
    const Rise rise = rise_of_leg(route, 2);
    EXPECT_NEAR(rise.up_m, up, 1e-5);
    EXPECT_NEAR(rise.down_m, down, 1e-5);
    EXPECT_NEAR(steepest_angle_of_leg(route, 2, 1), steepest, 1e-3);
    EXPECT_NEAR(steepest_angle_of_leg(route, 2, -1), deepest, 1e-3);
  }
}

TEST(TiltedArc, ExposureAgreesWithASum) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Stream random(seed, 2, 1);
    const Vec3 heading = random_unit(random);
    const Vec3 side = heading.cross(random_unit(random)).normalized();
    const Route route = turning_route(heading, side, 2 * kPi * random.uniform());
    const Vec3 center = route.segment(2).a + kRadius * side;
    const bool cylinder = seed % 2 == 0;
    const Threat threat{.name = "",
                        .shape = cylinder ? Threat::Shape::cylinder : Threat::Shape::sphere,
                        .center = center + 150 * random_unit(random),
                        .radius_m = 300,
                        .level = 0.5,
                        .floor_m = center.z() - 100,
                        .top_m = center.z() + 50};
    constexpr int kPieces = 200000;
    double mean = 0;
    for (int k = 0; k < kPieces; ++k) {
      const Vec3 at = point_on_leg(route, 2, (k + 0.5) / kPieces);
      if (cylinder && (at.z() < threat.floor_m || at.z() > threat.top_m)) continue;
      const Vec3 away = at - threat.center;
      mean += std::max(0.0, 1 - (cylinder ? away.head<2>().norm() : away.norm()) / threat.radius_m) / kPieces;
    }
    EXPECT_NEAR(exposure(threat, route, 2), 0.5 * length_of_leg(route, 2) * mean, 0.01) << seed;
  }
}

TEST(TiltedArc, GroundIsJudgedUnderIt) {
  const Route route = turning_route(Vec3::UnitX(), -Vec3::UnitZ(), kPi);
  Site site = turning_site(route);
  site.ground = PeakGround{.peaks = {}, .area = {.min = {-2000, -2000}, .max = {2000, 2000}}};
  site.band.clearance_m = 599;
  EXPECT_TRUE(check(site, route).ok());
  site.band.ceiling_amsl_m = 999;
  EXPECT_TRUE(broken_legs(check(site, route)).contains(2));
}

struct TurnMutation {
  const char* name;
  std::function<void(Route&)> change;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const TurnMutation& mutation, std::ostream* out) { *out << mutation.name; }

const std::vector<TurnMutation> kTurnMutations{
    {"Tighter",
     [](Route& route) {
       const Route tight = turning_route(Vec3::UnitX(), Vec3::UnitZ(), 1);
       const auto shrunk = [&](std::size_t i) -> Vec3 { return tight.states[i].position * 0.99; };
       for (std::size_t i = 0; i < 4; ++i) route.states[i].position = shrunk(i);
       const Arc& arc = *tight.states[2].arc;
       route.states[2].arc = Arc{.center = arc.center * 0.99,
                                 .radius_m = kRadius * 0.99,
                                 .angle_rad = 1,
                                 .plane = ArcPlane{arc.plane->center_z_m * 0.99, arc.plane->normal}};
     }},
    {"ShortOfItsEnd", [](Route& route) { route.states[2].arc->angle_rad -= 1e-6; }},
    {"CentreTooLow", [](Route& route) { route.states[2].arc->plane->center_z_m -= 1e-4; }},
    {"TurnedOver", [](Route& route) { route.states[2].arc->plane->normal *= -1; }},
    {"InAnotherPlane", [](Route& route) { route.states[2].arc->plane->normal = Vec3(0.01, 0, 1).normalized(); }},
    {"WithoutItsPlane", [](Route& route) { route.states[2].arc->plane.reset(); }},
    {"Teleport", [](Route& route) { route.states[2].arc->angle_rad = 0; }},
    {"KinkBehindIt", [](Route& route) { route.states[3].position.z() += 0.01; }},
    {"KinkBeforeIt", [](Route& route) { route.states[0].position.z() += 0.01; }},
};

class OneTurnMutation : public testing::TestWithParam<TurnMutation> {};

TEST_P(OneTurnMutation, BreaksTheTurnRuleAlone) {
  Route route = example_turn();
  Site site = turning_site(route);
  GetParam().change(route);
  site.mission.start = route.states.front().position;
  site.mission.goal = route.states.back().position;
  EXPECT_EQ(broken_rules(check(site, route)), std::set<std::string>{"turn"});
}

INSTANTIATE_TEST_SUITE_P(Each, OneTurnMutation, testing::ValuesIn(kTurnMutations),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(TiltedArc, SteepPartBreaksTheClimbRule) {
  const Route route = turning_route(Vec3::UnitX(), Vec3::UnitZ(), radians(30));
  Site site = turning_site(route);
  site.vehicle.climb_rad = radians(31);
  EXPECT_TRUE(check(site, route).ok());
  site.vehicle.climb_rad = radians(29);
  EXPECT_EQ(broken_legs(check(site, route)), (std::set<std::size_t>{2, 3}));
}

TEST(TiltedArc, ClimbOfStraightLegsIsATurnInSpaceAlone) {
  const Route route = make_route({{0, 0, 0}, {300, 0, 0}, {600, 0, 300}});
  Site site = turning_site(route);
  EXPECT_TRUE(check(site, route).ok());
  site.navigation->turn_radius_m = 800;
  EXPECT_EQ(broken_rules(check(site, route)), std::set<std::string>{"turn"});
  EXPECT_NEAR(find_margin(check(site, route), "turn")->margin, 300 / std::tan(kPi / 8) - 800, 1e-9);
  site.navigation->turn_model = TurnModel::none;
  EXPECT_TRUE(check(site, route).ok());
  EXPECT_NE(find_not_checked(check(site, route), "turn"), nullptr);
}

TEST(TiltedArc, MissingItsEndIsBrokenEvenWithoutATurnRadius) {
  Route route = example_turn();
  Site site = turning_site(route);
  site.navigation.reset();
  EXPECT_TRUE(check(site, route).ok());
  route.states[2].arc->angle_rad = 0;
  EXPECT_EQ(broken_legs(check(site, route)), std::set<std::size_t>{2});
}

TEST(TiltedArc, NonsenseBreaksBounds) {
  const double nan = std::nan("");
  for (const ArcPlane& plane : {ArcPlane{nan, Vec3::UnitZ()}, ArcPlane{0, {0, 0, 2}}, ArcPlane{0, {0, 0, 0}},
                                ArcPlane{0, {nan, 0, 1}}, ArcPlane{1e300, Vec3::UnitZ()}}) {
    Route route = example_turn();
    route.states[2].arc->plane = plane;
    EXPECT_EQ(broken_rules(check(turning_site(route), route)), std::set<std::string>{"bounds"});
  }
  Route route = example_turn();
  route.states[2].arc->angle_rad *= -1;
  EXPECT_EQ(broken_rules(check(turning_site(route), route)), std::set<std::string>{"bounds"});
}

}  // namespace
}  // namespace alate::test
