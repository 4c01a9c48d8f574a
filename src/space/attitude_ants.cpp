#include "space/attitude_ants.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

void narrow(const AlignedDoubles& from, AlignedFloats& to) {
  std::ranges::transform(from, to.begin(), [](double value) { return static_cast<float>(value); });
}

}  // namespace

AttitudeAnts::AttitudeAnts(const World& world, const AttitudeSpace& space)
    : site_(world.site()),
      space_(space),
      moves_(move_matrices(space.rotations())),
      nodes_(site_, space.objective().node_threats()),
      step_m_(static_cast<float>(*site_.vehicle.step_m)) {
  const Vehicle& vehicle = site_.vehicle;
  single_ = !space.objective().is_physical() && !vehicle.climb_rad && !vehicle.descent_rad && !vehicle.turn_radius_m;
}

void AttitudeAnts::look(const State& state, Choices& out) const {
  out.resize(actions());
  if (single_) {
    place_choices(moves_, AntPose(state.position - site_.mission.start, state.attitude), step_m_, out);
    price_choices(nodes_, out);
  } else {
    look_in_double(state, out);
  }
  std::fill(out.cost.begin() + static_cast<std::ptrdiff_t>(actions()), out.cost.end(),
            std::numeric_limits<float>::infinity());
}

void AttitudeAnts::look_in_double(const State& state, Choices& out) const {
  space_.expand(state, out.wide);
  place_choices(moves_, AntPose(state.position - site_.mission.start, state.attitude), step_m_, out);
  narrow(out.wide.to_goal, out.to_goal);
  narrow(out.wide.cost, out.cost);
  narrow(out.wide.guide, out.guide);
}

std::optional<double> AttitudeAnts::fly(std::span<const std::uint32_t> actions) const {
  double cost = 0;
  State state = start();
  for (const std::uint32_t k : actions) {
    if (is_goal(state)) return std::nullopt;
    State ahead = next(state, k);
    cost += space_.move_cost(state, ahead);
    if (cost == kInfinity || !is_free(state, ahead)) return std::nullopt;
    state = ahead;
  }
  return is_goal(state) ? std::optional(cost) : std::nullopt;
}

ReachBox AttitudeAnts::reach() const {
  const Vec3 goal = site_.mission.goal - site_.mission.start;
  const double sum = static_cast<double>(step_limit()) * *site_.vehicle.step_m + site_.mission.tolerance_m;
  const double flat = std::max(0.0, sum * sum - goal.squaredNorm());
  const double longest = std::max(goal.norm(), 1e-9);
  ReachBox box;
  for (int i = 0; i < 3; ++i) {
    // Half extent of the ellipsoid along axis i.
    const double along = goal[i] / longest;
    const double half = 0.5 * std::sqrt(sum * sum * along * along + flat * (1 - along * along));
    box.min[i] = static_cast<float>(0.5 * goal[i] - half);
    box.max[i] = static_cast<float>(0.5 * goal[i] + half);
  }
  return box;
}

double AttitudeAnts::step_price() const {
  const ObjectiveSpec& weights = space_.objective().weights();
  return *site_.vehicle.step_m * (space_.objective().is_physical() ? weights.length : weights.fuel);
}

}  // namespace alate
