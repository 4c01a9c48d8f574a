#include "space/correction_route.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <optional>

namespace alate {

namespace {

/// The turn ends at `to`.
void append_turn(Route& route, const Turn& turn, double radius_m, const Vec3& to) {
  route.states.push_back({.position = to,
                          .leg = LegKind::arc,
                          .arc = Arc{.center = turn.center.head<2>(),
                                     .radius_m = radius_m,
                                     .angle_rad = turn.angle_rad,
                                     .plane = ArcPlane{.center_z_m = turn.center.z(), .normal = turn.normal}}});
}

const CorrectionPoint* find(const Navigation& navigation, int id) {
  const auto found = std::ranges::find(navigation.points, id, &CorrectionPoint::id);
  return found == navigation.points.end() ? nullptr : &*found;
}

std::string name_of(const std::optional<int>& id, const char* otherwise) {
  return id ? fmt::format("point {}", *id) : otherwise;
}

/// Flies leg after leg, the heading at the end of each kept for the next.
class Pilot {
 public:
  explicit Pilot(const Site& site) : navigation_(*site.navigation) {
    route_.states.push_back({.position = site.mission.start, .leg = LegKind::start});
  }

  /// False if the leg cannot be flown.
  bool fly_to(const Vec3& to, std::optional<int> id) {
    const Vec3& from = route_.states.back().position;
    const bool turns = heading_ && navigation_.turn_model == TurnModel::arc_tangent;
    const auto leg = turns ? arc_tangent_leg({from, *heading_}, to, navigation_.turn_radius_m) : straight_leg(from, to);
    if (!leg) return false;
    append_leg(route_, *leg, navigation_.turn_radius_m, to);
    route_.states.back().point_id = id;
    heading_ = leg->heading;
    return true;
  }

  Route take() { return std::move(route_); }

 private:
  const Navigation& navigation_;
  Route route_;
  std::optional<Vec3> heading_;
};

RouteThrough refusal(const std::optional<int>& from, const std::optional<int>& to) {
  return {.route = {},
          .why = fmt::format("the leg from {} to {} cannot be flown: its end is too near for the turn",
                             name_of(from, "the start"), name_of(to, "the goal"))};
}

}  // namespace

void append_leg(Route& route, const TurningLeg& leg, double radius_m, const Vec3& to) {
  if (leg.leave.angle_rad > 0)
    append_turn(route, leg.leave, radius_m, position_on(leg.leave, route.states.back().position, leg.leave.angle_rad));
  if (leg.arrive.angle_rad > 0) {
    route.states.push_back({.position = position_on(leg.arrive, to, -leg.arrive.angle_rad), .leg = LegKind::straight});
    append_turn(route, leg.arrive, radius_m, to);
  } else {
    route.states.push_back({.position = to, .leg = LegKind::straight});
  }
}

RouteThrough route_through(const Site& site, std::span<const int> ids) {
  assert(site.navigation && site.navigation->turn_model != TurnModel::free_heading);
  Pilot pilot(site);
  std::optional<int> last;
  for (const int id : ids) {
    const CorrectionPoint* point = find(*site.navigation, id);
    if (point == nullptr) return {.route = {}, .why = fmt::format("there is no correction point {}", id)};
    if (!pilot.fly_to(point->position, id)) return refusal(last, id);
    last = id;
  }
  if (!pilot.fly_to(site.mission.goal, std::nullopt)) return refusal(last, std::nullopt);
  return {.route = pilot.take(), .why = {}};
}

}  // namespace alate
