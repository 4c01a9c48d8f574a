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

/// Work space and result of price_tails.
struct TailPrices {
  Choices ends, nodes;
  MoveMatrices attitudes;
  TailSums sums;
};

class AttitudeAnts {
 public:
  using State = AttitudeState;

  /// `space` must outlive this.
  AttitudeAnts(const World& world, const AttitudeSpace& space);

  const AttitudeSpace& lattice() const { return space_; }
  State start() const { return space_.start(); }
  std::size_t actions() const { return space_.actions(); }
  std::size_t step_limit() const { return space_.step_limit(); }
  float step_m() const { return step_m_; }

  /// Fills places, costs and guides of all choices.
  void look(const State& state, Choices& out) const;
  State next(const State& state, std::size_t k) const { return space_.next(state, k); }
  bool is_free(const State& from, const State& to) const { return space_.is_free(from, to); }
  bool is_goal(const State& state) const { return space_.is_goal(state); }

  /// Place relative to the start of the flight, as choices give it.
  Eigen::Vector3f place(const State& state) const { return (state.position - site_.mission.start).cast<float>(); }

  /// Flies `actions` from the start in double until the first arrival; nothing if a move may not be flown, or none
  /// arrives.
  std::optional<FlownActions> fly(std::span<const std::uint32_t> actions) const;

  double move_cost(const State& from, const State& to) const { return space_.move_cost(from, to); }
  double lower_bound(const State& state) const { return space_.lower_bound(state); }

  /// Does the kernel for ants price this scenario?
  bool in_single_precision() const { return single_; }

  /// Nodes of a string of actions, in body axes before it.
  void unroll(std::span<const std::uint32_t> actions, std::vector<TailNode>& nodes) const;

  /// Cost of every choice at `state` followed by a tail, until the first arrival, plus `cost_before`: in
  /// `out.sums.total`, infinite where it does not arrive or is not below `limit`.
  /// Under the kernel for ants `is_free` is not asked. Else every price is that of flying the tail exactly, and only
  /// arrivals with as many moves count; tails are given up early where they cannot well be cheaper than now.
  struct Branch {
    const State& state;
    double cost_before;
    double limit;
    std::span<const std::uint32_t> actions;  ///< The tail.
    std::span<const TailNode> nodes;         ///< The same, unrolled.
    std::span<const float> costs;            ///< What its moves cost now.
  };
  void price_tails(const Branch& branch, TailPrices& out) const;

  /// Where a route that arrives within the step limit can lead, relative to the start: the box of the ellipsoid with
  /// start and goal as foci.
  ReachBox reach() const;

  /// What one step more costs: its length, or under the node model fuel times half the direct distance, the mean
  /// distance of nodes from the goal. The scale of differences between choices.
  double step_price() const;

 private:
  void price_nodes(const Branch& branch, const AntPose& pose, TailPrices& out) const;
  void price_flights(const Branch& branch, TailPrices& out) const;
  double fly_tail(const Branch& branch, std::size_t choice) const;
  void look_in_double(const State& state, Choices& out) const;

  const Site& site_;
  const AttitudeSpace& space_;
  MoveMatrices moves_;
  NodeModel nodes_;
  float step_m_;
  bool single_;  ///< Node model without limits of the aircraft: the kernel for ants knows all.
};

}  // namespace alate
