#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "alate/core/stream.hpp"
#include "alate/world/world.hpp"
#include "support/jacksboro.hpp"

namespace alate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Lowest height above the ground at points `step_m` apart or closer; -infinity off the known ground.
double sampled_clearance(const Site& site, const Segment& leg, double step_m) {
  const int steps = std::max(1, static_cast<int>(std::ceil(leg.length() / step_m)));
  double lowest = kInfinity;
  for (int i = 0; i <= steps; ++i) {
    const Vec3 at = leg.at(static_cast<double>(i) / steps);
    const auto ground = site.ground_height(at.head<2>());
    if (!ground || std::isnan(*ground)) return -kInfinity;
    lowest = std::min(lowest, at.z() - *ground);
  }
  return lowest;
}

/// A leg somewhere over the site, up to `longest_m` long, from 50 m under ground level to 300 m above.
Segment random_leg(const Site& site, Stream& stream, double longest_m) {
  const Box2& area = std::get<HeightRaster>(site.ground).area;
  const auto between = [&](double low, double high) { return low + stream.uniform() * (high - low); };
  const Vec2 from{between(area.min.x(), area.max.x()), between(area.min.y(), area.max.y())};
  const double heading = between(0, 2 * kPi);
  const Vec2 to = from + between(0, longest_m) * direction_of(heading).head<2>();
  const auto height = [&](const Vec2& xy) { return site.ground_height(xy).value_or(500) + between(-50, 300); };
  return {{from.x(), from.y(), height(from)}, {to.x(), to.y(), height(to)}};
}

TEST(Clearance, IsNeverAboveDenseSamplingOnJacksboro) {
  const World world(test::jacksboro());
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Stream stream(7, 0, i);
    const Segment leg = random_leg(world.site(), stream, i % 10 == 0 ? 5000 : 500);
    const double sampled = sampled_clearance(world.site(), leg, 1);
    const double exact = world.clearance(leg);
    EXPECT_LE(exact, sampled + 1e-6) << i;
    EXPECT_GE(exact, sampled - 1.0) << i;
  }
}

}  // namespace
}  // namespace alate
