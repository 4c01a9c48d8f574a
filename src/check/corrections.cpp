#include "check/corrections.hpp"

#include <algorithm>
#include <map>

#include "check/leg_shape.hpp"

namespace alate {

namespace {

/// The points that the route names, by id.
std::map<int, const CorrectionPoint*> named_points(const Navigation& navigation, const Route& route) {
  std::vector<int> ids;
  for (const RouteState& state : route.states) {
    if (state.point_id) ids.push_back(*state.point_id);
  }
  std::ranges::sort(ids);
  std::map<int, const CorrectionPoint*> points;
  for (const CorrectionPoint& point : navigation.points) {
    if (std::ranges::binary_search(ids, point.id)) points.emplace(point.id, &point);
  }
  return points;
}

bool is_end(const Navigation& navigation, const Route& route, std::size_t i) {
  const std::optional<int>& id = route.states[i].point_id;
  return (i == 0 && id == navigation.start_id) || (i + 1 == route.states.size() && id == navigation.goal_id);
}

}  // namespace

std::vector<Visit> visits_of(const Navigation& navigation, const Route& route) {
  const auto points = named_points(navigation, route);
  std::vector<Visit> visits;
  double length = 0;
  for (std::size_t i = 0; i < route.states.size(); ++i) {
    if (i > 0) length += length_of_leg(route, i);
    const std::optional<int>& id = route.states[i].point_id;
    const bool point = id && !is_end(navigation, route, i);
    if (!point && i + 1 < route.states.size()) continue;
    const auto found = point ? points.find(*id) : points.end();
    const bool known = found != points.end();
    visits.push_back(
        {.state = i, .point = known ? found->second : nullptr, .unknown = point && !known, .length_m = length});
    length = 0;
  }
  return visits;
}

Errors grown(const Navigation& navigation, const Errors& errors, double length_m) {
  return {errors.vertical + navigation.drift_vertical * length_m,
          errors.horizontal + navigation.drift_horizontal * length_m};
}

Errors corrected(const Errors& errors, PointKind kind) {
  return kind == PointKind::vertical ? Errors{0, errors.horizontal} : Errors{errors.vertical, 0};
}

Errors uncorrected(const Navigation& navigation, const Errors& errors, PointKind kind) {
  const double most = navigation.residual;
  return kind == PointKind::vertical ? Errors{std::min(errors.vertical, most), errors.horizontal}
                                     : Errors{errors.vertical, std::min(errors.horizontal, most)};
}

const Navigation::Limits& limits_at(const Navigation& navigation, PointKind kind) {
  return kind == PointKind::vertical ? navigation.at_vertical : navigation.at_horizontal;
}

}  // namespace alate
