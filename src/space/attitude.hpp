// The attitude lattice: position and attitude after a number of steps of one length.
//
// Source: Konatowski, Pawlowski 2019, section 2. Departures: leg costs and limits are the scenario's; candidates that
// break them are not in K; signs as told in rotations.hpp. One expansion costs 3-4 ns per candidate, and
// some 30 more with guidance.
#pragma once

#include <cstdint>

#include "space/cost_to_go.hpp"
#include "space/objective.hpp"
#include "space/rotations.hpp"
#include "space/space.hpp"

namespace alate {

struct AttitudeState {
  Vec3 position;
  Mat3 attitude;  ///< Columns: body axes forward, left, up in the frame.
  int step = 0;
};

struct AttitudeOptions {
  std::size_t step_limit = 0;  ///< 0: 3.4 x direct distance / step, and no more than the vehicle's range.
  ThreatsAt threats_at = ThreatsAt::nodes;
};

/// Immutable; any thread may ask. World and guidance must outlive it.
class AttitudeSpace {
 public:
  using State = AttitudeState;

  /// The vehicle must have attitude steps. Without `guidance` the guide is the lower bound. In the physical model the
  /// turn that the last approach needs is added.
  AttitudeSpace(const World& world, const CostToGo* guidance, const AttitudeOptions& options = {});

  State start() const;
  std::size_t actions() const { return rotations_.size(); }
  void expand(const State& state, Candidates& out) const;
  bool arrives(const Candidates& candidates, std::size_t k) const;
  State next(const State& state, std::size_t k) const;
  bool is_free(const State& from, const State& to) const;
  /// Cost of the leg between two states in a row; infinite where a limit of the aircraft is broken.
  double move_cost(const State& from, const State& to) const;
  bool is_goal(const State& state) const;
  double lower_bound(const State& state) const;
  /// Scale 1: half a step in the plane, an eighth in height, 15 degrees of direction.
  std::uint64_t bin(const State& state, double scale) const;
  std::size_t step_limit() const { return step_limit_; }

  /// Bound from the start, with the turn limit where the model allows it.
  double problem_bound() const;
  const Objective& objective() const { return objective_; }
  const RotationSet& rotations() const { return rotations_; }

 private:
  BaseCosts base_costs(const State& state) const;
  void fill_guide(Candidates& out) const;

  const World& world_;
  const Site& site_;
  const CostToGo* guidance_;
  Objective objective_;
  RotationSet rotations_;
  double step_m_;
  double turn_radius_m_;  ///< Of the sharpest moves in a row.
  LegLimits limits_;
  std::size_t step_limit_;
};

static_assert(Space<AttitudeSpace>);

}  // namespace alate
