// The room that `check` sees at corners is that of the circles that round them: all at once, and no larger ones.
#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "check/example.hpp"

namespace alate::test {
namespace {

Site open_site(const Route& route, double radius_m) {
  Site site;
  site.mission = {.start = route.states.front().position, .goal = route.states.back().position, .tolerance_m = 1};
  site.vehicle.turn_radius_m = radius_m;
  return site;
}

Route random_corners(Stream& random) {
  std::vector<Vec3> places{Vec3::Zero()};
  double heading = 0;
  for (int k = 0; k < 6; ++k) {
    heading += 4 * (random.uniform() - 0.5);
    const double length = 100 + 900 * random.uniform();
    places.emplace_back(places.back() + length * Vec3(std::sin(heading), std::cos(heading), 0));
  }
  return make_route(places);
}

void add(Route& route, const Vec3& position) {
  route.states.push_back({.position = position, .leg = route.empty() ? LegKind::start : LegKind::straight});
}

/// Each corner as an arc between straight legs, which run backward where two arcs overlap.
Route rounded(const Route& route, double radius_m) {
  Route out;
  add(out, route.states.front().position);
  for (std::size_t k = 1; k + 1 < route.states.size(); ++k) {
    const Vec3 corner = route.states[k].position;
    const Vec3 before = (corner - route.states[k - 1].position).normalized();
    const Vec3 after = (route.states[k + 1].position - corner).normalized();
    const double right = before.y() * after.x() - before.x() * after.y();
    const double angle = std::copysign(std::acos(before.dot(after)), right);
    const double reach = radius_m * std::tan(std::abs(angle) / 2);
    const Vec3 begin = corner - reach * before;
    const Vec2 side = std::copysign(radius_m, angle) * Vec2(before.y(), -before.x());
    add(out, begin);
    add(out, corner + reach * after);
    out.states.back().leg = LegKind::arc;
    out.states.back().arc = Arc{.center = begin.head<2>() + side, .radius_m = radius_m, .angle_rad = angle};
  }
  add(out, route.states.back().position);
  return out;
}

TEST(CornerRoom, IsThatOfTheCirclesThatRoundAllCorners) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Stream random(seed, 0, 0);
    const Route route = random_corners(random);
    const double room = find_margin(check(open_site(route, 1), route), "turn")->margin + 1;
    const double just_less = room * (1 - 1e-6);
    const double just_more = room * (1 + 1e-4);
    const Route flown = rounded(route, just_less);
    EXPECT_TRUE(check(open_site(flown, just_less), flown).ok()) << seed;
    const Route overlapping = rounded(route, just_more);
    EXPECT_FALSE(check(open_site(overlapping, just_more), overlapping).ok()) << seed;
  }
}

}  // namespace
}  // namespace alate::test
