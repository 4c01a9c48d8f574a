#include "space/sure_leg.hpp"

namespace alate {

double hill_slack_m(const Site& site) {
  constexpr double kSlack_m = 0.051;
  const auto* hills = std::get_if<PeakGround>(&site.ground);
  return hills != nullptr && !hills->peaks.empty() ? kSlack_m : 0;
}

bool is_surely_free(const World& world, const Segment& leg) {
  const Vec3 slack(0, 0, hill_slack_m(world.site()));
  if (!world.is_free(leg)) return false;
  if (slack.z() == 0) return true;
  if (!world.is_free({leg.a - slack, leg.b - slack})) return false;
  return !world.site().band.ceiling_agl_m || world.is_free({leg.a + slack, leg.b + slack});
}

}  // namespace alate
