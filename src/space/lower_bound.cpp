#include "space/lower_bound.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

constexpr int kDirections = 4096;
/// After so many steps, or once any direction is within reach, only the length of the steps counts.
constexpr int kTurningSteps = 1000;

/// Shortest flight that loses or gains `rise_m` at the steepest angle allowed.
double slope_length(double rise_m, const Vehicle& vehicle) {
  const auto& limit = rise_m > 0 ? vehicle.climb_rad : vehicle.descent_rad;
  const double sine = limit ? std::sin(std::min(*limit, kPi / 2)) : 1.0;
  return sine > 0 ? std::abs(rise_m) / sine : 0.0;
}

}  // namespace

double physical_bound(const Site& site, const Vec3& from) {
  const ObjectiveSpec& weights = site.scenario.objective;
  const Mission& mission = site.mission;
  const double rise = mission.goal.z() - from.z();
  const double needed = std::copysign(std::max(0.0, std::abs(rise) - mission.tolerance_m), rise);
  const double straight = std::max(0.0, (mission.goal - from).norm() - mission.tolerance_m);
  return weights.length * std::max(straight, slope_length(needed, site.vehicle)) +
         weights.climb * std::max(0.0, needed);
}

double node_bound(double distance_m, double fuel, double step_m, double tolerance_m) {
  const double steps = std::max(0.0, std::ceil((distance_m - tolerance_m) / step_m));
  const double counted = std::min(steps, std::floor(distance_m / step_m));
  return fuel * (counted * distance_m - step_m * counted * (counted + 1) / 2);
}

double turn_limited_node_bound(const Site& site, double largest_turn_rad) {
  const Mission& mission = site.mission;
  const double step = site.vehicle.step_m.value_or(0);
  const Vec3 to_goal = mission.goal - mission.start;
  const double distance = to_goal.norm();
  if (step <= 0 || distance <= mission.tolerance_m) return 0;
  const double cosine = direction_of(mission.heading_rad).dot(to_goal) / distance;
  const double goal_angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  std::vector<double> left(kDirections + 1);  // n.(goal - start) - what the steps so far can have gained along n
  for (int j = 0; j <= kDirections; ++j)
    left[static_cast<std::size_t>(j)] = distance * std::cos(kPi * j / kDirections - goal_angle);
  double sum = 0;
  double nearest = distance;
  for (int i = 1; i <= kTurningSteps && (i - 1) * largest_turn_rad < kPi && nearest > mission.tolerance_m; ++i) {
    nearest = 0;
    for (int j = 0; j <= kDirections; ++j) {
      double& rest = left[static_cast<std::size_t>(j)];
      rest -= step * std::cos(std::max(0.0, kPi * j / kDirections - i * largest_turn_rad));
      nearest = std::max(nearest, rest);
    }
    sum += nearest;
  }
  const double fuel = site.scenario.objective.fuel;
  return fuel * sum + node_bound(nearest, fuel, step, mission.tolerance_m);
}

}  // namespace alate
