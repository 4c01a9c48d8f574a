#include "space/bound/passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Passage::Tilt::Tilt(double slope) : cosine(std::cos(std::atan(slope))), sine(std::sin(std::atan(slope))) {}

Passage::Passage(const Problem& problem)
    : weights_(problem.objective),
      mission_(problem.mission),
      slopes_(optimistic_slopes(problem.vehicle)),
      climb_(slopes_.climb),
      descent_(slopes_.descent),
      goal_{.low = mission_.goal.z() - mission_.tolerance_m, .high = mission_.goal.z() + mission_.tolerance_m} {}

double Passage::price(const Box2& box, const Altitudes& open) const {
  const Ways ways{.from_start_m = distance_to(box, mission_.start.head<2>()),
                  .to_goal_m = std::max(0.0, distance_to(box, mission_.goal.head<2>()) - mission_.tolerance_m)};
  const double z = mission_.start.z();
  // Where the price may bend: at the ends, and where a slope limit begins to tell.
  const std::array kinks{open.low,
                         open.high,
                         z,
                         z + slopes_.climb * ways.from_start_m,
                         z - slopes_.descent * ways.from_start_m,
                         goal_.low,
                         goal_.high,
                         goal_.low - slopes_.climb * ways.to_goal_m,
                         goal_.high + slopes_.descent * ways.to_goal_m};
  std::array<double, 3> least{kInfinity, kInfinity, kInfinity};
  for (const double kink : kinks) {
    const double at = std::clamp(kink, open.low, open.high);
    if (!std::isfinite(at)) continue;
    const std::array<double, 3> here = prices(ways, at);
    for (std::size_t k = 0; k < here.size(); ++k) least[k] = std::min(least[k], here[k]);
  }
  return *std::ranges::max_element(least);
}

double Passage::least(double planar_m) const {
  const std::array<double, 3> all = prices({.to_goal_m = planar_m}, mission_.start.z());
  return *std::ranges::max_element(all);
}

bool Passage::ends_at(const Box2& box, const Altitudes& open) const {
  return distance_to(box, mission_.goal.head<2>()) <= mission_.tolerance_m && open.overlap(goal_);
}

/// Of a flight p metres long seen from above that goes v metres up and down, the length in space is at least
/// p cos a + v sin a for any angle a: here level, and the steepest climb and descent.
std::array<double, 3> Passage::prices(const Ways& ways, double z) const {
  const double up = std::max(0.0, z - mission_.start.z());
  const double down = std::max(0.0, mission_.start.z() - z);
  const double up_after = std::max(0.0, goal_.low - z);
  const double down_after = std::max(0.0, z - goal_.high);
  const double planar = std::max({ways.from_start_m, up / slopes_.climb, down / slopes_.descent}) +
                        std::max({ways.to_goal_m, up_after / slopes_.climb, down_after / slopes_.descent});
  const double vertical = up + down + up_after + down_after;
  const double ascent = weights_.climb * (up + up_after);
  const auto tilted = [&](const Tilt& by) {
    return weights_.length * (planar * by.cosine + vertical * by.sine) + ascent;
  };
  return {weights_.length * planar + ascent, tilted(climb_), tilted(descent_)};
}

}  // namespace alate
