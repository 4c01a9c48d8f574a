#include "plan/correction/correction_plan.hpp"

#include <algorithm>

#include "space/correction_route.hpp"
#include "space/error_cases.hpp"
#include "space/turning_flight.hpp"

namespace alate {

namespace {

std::vector<int> ids_of(const std::vector<CorrectionPoint>& points) {
  std::vector<int> ids;
  for (const CorrectionPoint& point : points) ids.push_back(point.id);
  return ids;
}

/// As correction_refusal, of what concerns turns alone.
std::string turn_refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  const auto& radius = problem.vehicle.turn_radius_m;
  if (site.navigation->turn_model == TurnModel::none)
    return radius ? "flies straight legs with corners, which the vehicle's turning radius forbids; leave out "
                    "vehicle.turn_radius_m, or give navigation.turn_model"
                  : "";
  if (radius.value_or(0) > site.navigation->turn_radius_m)
    return "turns on navigation.turn_radius_m, which is below vehicle.turn_radius_m";
  if (has_obstacles(site))
    return "turns in open air only; leave out terrain, ceilings, cores and climb limits, or set navigation.turn_model "
           "to none";
  if (problem.prefer == Preference::probability)
    return "turns on routes with few corrections or little length, whatever their probability of success; prefer one "
           "of these, or set navigation.turn_model to none";
  return "";
}

}  // namespace

std::string correction_refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  const ObjectiveSpec& objective = problem.objective;
  if (!site.navigation) return "flies from correction point to correction point; add navigation";
  if (std::string refusal = turn_refusal(problem); !refusal.empty()) return refusal;
  if (objective.model != CostModel::physical || objective.length <= 0)
    return "looks for the shortest route; set objective.model to physical and objective.length above 0";
  if (objective.climb > 0) return "looks for the shortest route, whatever it climbs; set objective.climb to 0";
  const auto exposes = [](const Threat& threat) { return threat.level > 0 && threat.radius_m > 0; };
  if (objective.threat > 0 && std::ranges::any_of(site.threats, exposes))
    return "looks for the shortest route, whatever it is exposed to; set objective.threat to 0 (cores are kept)";
  return "";
}

Route route_over(const Site& site, const std::vector<CorrectionPoint>& points) {
  return route_through(site, ids_of(points)).route;
}

FrontPoint front_point(const Site& site, const CorrectionRoute& route) {
  std::vector<Vec3> places{site.mission.start};
  for (const CorrectionPoint& point : route.points) places.push_back(point.position);
  places.push_back(site.mission.goal);
  std::vector<CorrectionLeg> legs;
  for (const TurningLeg& leg : fly_over(places, turn_rule(site)).legs) {
    const std::size_t i = legs.size();
    legs.push_back({.length_m = leg.length_m,
                    .kind = i < route.points.size() ? route.points[i].kind : PointKind::end,
                    .success = i < route.points.size() ? route.points[i].success : 1});
  }
  return {.length_m = route.length_m,
          .corrections = static_cast<int>(route.points.size()),
          .probability = success_probability(*site.navigation, legs),
          .points = ids_of(route.points)};
}

}  // namespace alate
