#include "plan/correction_plan.hpp"

#include <algorithm>

#include "space/error_cases.hpp"

namespace alate {

std::string correction_refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  const ObjectiveSpec& objective = problem.objective;
  if (!site.navigation) return "flies from correction point to correction point; add navigation";
  if (site.navigation->turn_model != TurnModel::none)
    return "flies straight legs only; set navigation.turn_model to none";
  if (problem.vehicle.turn_radius_m)
    return "flies straight legs with corners, which the vehicle's turning radius forbids; leave out "
           "vehicle.turn_radius_m";
  if (objective.model != CostModel::physical || objective.length <= 0)
    return "looks for the shortest route; set objective.model to physical and objective.length above 0";
  if (objective.climb > 0) return "looks for the shortest route, whatever it climbs; set objective.climb to 0";
  const auto exposes = [](const Threat& threat) { return threat.level > 0 && threat.radius_m > 0; };
  if (objective.threat > 0 && std::ranges::any_of(site.threats, exposes))
    return "looks for the shortest route, whatever it is exposed to; set objective.threat to 0 (cores are kept)";
  return "";
}

Route straight_route(const Mission& mission, const std::vector<CorrectionPoint>& points) {
  Route route;
  route.states.push_back({.position = mission.start, .leg = LegKind::start});
  for (const CorrectionPoint& point : points)
    route.states.push_back({.position = point.position, .leg = LegKind::straight, .point_id = point.id});
  route.states.push_back({.position = mission.goal, .leg = LegKind::straight});
  return route;
}

FrontPoint front_point(const Site& site, const CorrectionRoute& route) {
  FrontPoint result{
      .length_m = route.length_m,
      .corrections = static_cast<int>(route.points.size()),
      .probability = success_probability(*site.navigation, site.mission.start, site.mission.goal, route.points)};
  for (const CorrectionPoint& point : route.points) result.points.push_back(point.id);
  return result;
}

}  // namespace alate
