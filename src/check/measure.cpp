#include <algorithm>

#include "alate/check/check.hpp"
#include "check/corrections.hpp"
#include "check/exposure.hpp"
#include "check/flight.hpp"
#include "check/grid_measures.hpp"
#include "check/leg_shape.hpp"
#include "check/success_chance.hpp"

namespace alate {

namespace {

/// Lowest height above ground of the whole route; nothing where any part has none or an unknown one.
std::optional<double> min_clearance(const Site& site, const Route& route) {
  std::optional<double> least;
  for (const Leg& leg : Flight(site, route).legs) {
    const HeightRange& range = leg.above_ground;
    if (range.unknown || !range.lowest) return std::nullopt;
    least = std::min(least.value_or(range.lowest->height_m), range.lowest->height_m);
  }
  return least;
}

/// Konatowski and Pawlowski 2019, eqs. 33-34: sums over the nodes, the start excluded.
double node_cost(const Site& site, const Route& route, double exposure_sum) {
  const ObjectiveSpec& objective = site.scenario.objective;
  double distance = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    distance += (route.states[i].position - site.mission.goal).norm();
  }
  return objective.fuel * distance + objective.threat * exposure_sum;
}

double physical_cost(const Site& site, const Metrics& metrics) {
  const ObjectiveSpec& objective = site.scenario.objective;
  return objective.length * metrics.length_m + objective.threat * metrics.threat + objective.climb * metrics.climb_m;
}

void measure_corrections(const Navigation& navigation, const Route& route, Metrics& metrics) {
  const std::vector<Visit> visits = visits_of(navigation, route);
  const auto corrects = [](const Visit& visit) { return visit.point != nullptr; };
  metrics.corrections = static_cast<std::size_t>(std::ranges::count_if(visits, corrects));
  metrics.probability = success_chance(navigation, visits);
}

}  // namespace

Metrics measure(const Site& site, const Route& route) {
  Metrics metrics;
  if (route.empty() || first_unusable_state(route)) return metrics;
  const bool nodes_only = site.scenario.objective.model == CostModel::konatowski2019;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const Vec3& at = route.states[i].position;
    const Rise rise = rise_of_leg(route, i);
    metrics.length_m += length_of_leg(route, i);
    metrics.climb_m += rise.up_m;
    metrics.descent_m += rise.down_m;
    for (const Threat& threat : site.threats) {
      metrics.threat += nodes_only ? point_exposure(threat, at) : exposure(threat, route, i);
    }
  }
  metrics.cost = nodes_only ? node_cost(site, route, metrics.threat) : physical_cost(site, metrics);
  metrics.min_clearance_m = min_clearance(site, route);
  if (site.grid) metrics.grid = grid_measures(*site.grid, route);
  if (site.navigation) measure_corrections(*site.navigation, route, metrics);
  return metrics;
}

}  // namespace alate
