#include "space/correction_route.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "space/turning_flight.hpp"

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

std::string point_name(int id) { return fmt::format("point {}", id); }

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
  assert(site.navigation);
  std::vector<Vec3> places{site.mission.start};
  for (const int id : ids) {
    const CorrectionPoint* point = find(*site.navigation, id);
    if (point == nullptr) return {.route = {}, .why = fmt::format("there is no correction point {}", id)};
    places.push_back(point->position);
  }
  places.push_back(site.mission.goal);
  const TurningFlight flight = fly_over(places, turn_rule(site));
  const std::size_t flown = flight.legs.size();
  if (flown <= ids.size())
    return {.route = {},
            .why = fmt::format("the leg from {} to {} cannot be flown: its end is too near for the turn",
                               flown > 0 ? point_name(ids[flown - 1]) : "the start",
                               flown < ids.size() ? point_name(ids[flown]) : "the goal")};
  RouteThrough through;
  through.route.states.push_back({.position = site.mission.start, .leg = LegKind::start});
  for (std::size_t i = 0; i < flown; ++i) {
    append_leg(through.route, flight.legs[i], site.navigation->turn_radius_m, places[i + 1]);
    if (i < ids.size()) through.route.states.back().point_id = ids[i];
  }
  return through;
}

}  // namespace alate
