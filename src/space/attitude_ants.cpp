#include "space/attitude_ants.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

void narrow(const AlignedDoubles& from, AlignedFloats& to) {
  std::ranges::transform(from, to.begin(), [](double value) { return static_cast<float>(value); });
}

void close_padding(std::size_t count, Choices& choices) {
  std::fill(choices.cost.begin() + static_cast<std::ptrdiff_t>(count), choices.cost.end(),
            std::numeric_limits<float>::infinity());
}

}  // namespace

AttitudeAnts::AttitudeAnts(const World& world, const AttitudeSpace& space)
    : site_(world.site()),
      space_(space),
      moves_(move_matrices(space.rotations())),
      nodes_(site_, space.objective().node_threats()),
      step_m_(static_cast<float>(*site_.vehicle.step_m)) {
  const Vehicle& vehicle = site_.vehicle;
  single_ = space.objective().is_of_nodes() && !vehicle.climb_rad && !vehicle.descent_rad && !vehicle.turn_radius_m;
}

void AttitudeAnts::look(const State& state, Choices& out) const {
  out.resize(actions());
  if (single_) {
    const AntPose pose(state.position - site_.mission.start, state.attitude);
    look_one_step(nodes_, moves_, pose, out);
  } else {
    look_in_double(state, out);
  }
  close_padding(actions(), out);
}

void AttitudeAnts::look_in_double(const State& state, Choices& out) const {
  space_.expand(state, out.wide);
  place_choices(moves_, AntPose(state.position - site_.mission.start, state.attitude), step_m_, out);
  narrow(out.wide.to_goal, out.to_goal);
  narrow(out.wide.cost, out.cost);
  narrow(out.wide.guide, out.guide);
}

std::optional<FlownActions> AttitudeAnts::fly(std::span<const std::uint32_t> actions) const {
  FlownActions flight;
  State state = start();
  for (const std::uint32_t k : actions) {
    State ahead = next(state, k);
    const double cost = space_.move_cost(state, ahead);
    flight.cost += cost;
    flight.costs.push_back(static_cast<float>(cost));
    ++flight.moves;
    if (flight.cost == kInfinity || !is_free(state, ahead)) return std::nullopt;
    state = ahead;
    if (is_goal(state)) return flight;
  }
  return std::nullopt;
}

void AttitudeAnts::unroll(std::span<const std::uint32_t> actions, std::vector<TailNode>& nodes) const {
  nodes.clear();
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  Eigen::Matrix3f attitude = Eigen::Matrix3f::Identity();
  for (const std::uint32_t k : actions) {
    attitude = attitude * space_.rotations().matrix(k).cast<float>();
    place += step_m_ * attitude.col(0);
    nodes.push_back({place.x(), place.y(), place.z()});
  }
}

void AttitudeAnts::price_tails(const Branch& branch, TailPrices& out) const {
  const AntPose pose(branch.state.position - site_.mission.start, branch.state.attitude);
  out.ends.resize(actions());
  out.nodes.resize(actions());
  turn_moves(moves_, pose, out.attitudes);
  if (single_) {
    price_nodes(branch, pose, out);
  } else {
    place_choices(moves_, pose, step_m_, out.ends);
    price_flights(branch, out);
  }
}

void AttitudeAnts::price_nodes(const Branch& branch, const AntPose& pose, TailPrices& out) const {
  look_one_step(nodes_, moves_, pose, out.ends);
  close_padding(actions(), out.ends);
  float least = start_tails(static_cast<float>(branch.cost_before), nodes_.tolerance, out.ends, out.sums);
  for (const TailNode& node : branch.nodes) {
    if (least >= static_cast<float>(branch.limit)) break;
    least = add_tail_node(nodes_, {out.attitudes, node, out.ends}, out.nodes, out.sums);
  }
}

void AttitudeAnts::price_flights(const Branch& branch, TailPrices& out) const {
  const TailNode last = branch.nodes.empty() ? TailNode{} : branch.nodes.back();
  measure_tail_node(nodes_, {out.attitudes, last, out.ends}, out.nodes);
  out.sums.total.assign(out.ends.x.size(), std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < actions(); ++k)
    if (out.nodes.to_goal[k] <= nodes_.tolerance) out.sums.total[k] = static_cast<float>(fly_tail(branch, k));
}

double AttitudeAnts::fly_tail(const Branch& branch, std::size_t choice) const {
  constexpr double kLikely = 0.9;  // a tail that is moved a little costs about what it did
  double later = 0;
  for (const float cost : branch.costs) later += static_cast<double>(cost);
  double cost = branch.cost_before;
  State state = branch.state;
  const double leg = step_price();
  for (std::size_t i = 0; i <= branch.actions.size(); ++i) {
    State ahead = next(state, i == 0 ? choice : branch.actions[i - 1]);
    cost += space_.move_cost(state, ahead);
    if (i > 0) later -= static_cast<double>(branch.costs[i - 1]);
    const double bare = leg * static_cast<double>(branch.actions.size() - i);
    if (!(cost + bare + kLikely * (later - bare) < branch.limit) || !is_free(state, ahead)) return kInfinity;
    state = ahead;
  }
  return is_goal(state) ? cost : kInfinity;
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
  if (space_.objective().is_physical()) return *site_.vehicle.step_m * weights.length;
  return weights.fuel * (site_.mission.goal - site_.mission.start).norm() / 2;
}

}  // namespace alate
