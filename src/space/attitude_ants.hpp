// The attitude lattice as ants see it: choices in single precision, the chosen move in double precision.
//
// Source and departures as in attitude.hpp. Under the node model all choices are priced by the kernel for ants; under
// the physical model they are those of AttitudeSpace, narrowed. Either way a route is rebuilt and costed in double.
#pragma once

#include <optional>
#include <span>

#include "space/ant_kernel.hpp"
#include "space/attitude.hpp"

namespace alate {

class AttitudeAnts {
 public:
  using State = AttitudeState;

  /// `space` must outlive this.
  AttitudeAnts(const World& world, const AttitudeSpace& space);

  State start() const { return space_.start(); }
  std::size_t actions() const { return space_.actions(); }
  std::size_t step_limit() const { return space_.step_limit(); }

  /// Fills places, costs and guides of all choices.
  void look(const State& state, Choices& out) const;
  State next(const State& state, std::size_t k) const { return space_.next(state, k); }
  bool is_free(const State& from, const State& to) const { return space_.is_free(from, to); }
  bool is_goal(const State& state) const { return space_.is_goal(state); }

  /// Place relative to the start of the flight, as choices give it.
  Eigen::Vector3f place(const State& state) const { return (state.position - site_.mission.start).cast<float>(); }

  /// Cost of flying `actions` from the start, in double; nothing unless every move may be flown and the last, and none
  /// before it, arrives.
  std::optional<double> fly(std::span<const std::uint32_t> actions) const;

  /// Where a route that arrives within the step limit can lead, relative to the start: the box of the ellipsoid with
  /// start and goal as foci.
  ReachBox reach() const;

  /// What one step towards the goal costs in open air: the scale of differences between choices.
  double step_price() const;

 private:
  void look_in_double(const State& state, Choices& out) const;

  const Site& site_;
  const AttitudeSpace& space_;
  MoveMatrices moves_;
  NodeModel nodes_;
  float step_m_;
  bool single_;  ///< Node model without limits of the aircraft: the kernel for ants knows all.
};

}  // namespace alate
