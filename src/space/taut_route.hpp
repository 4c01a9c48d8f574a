// A route of straight legs, pulled taut between what stands in its way.
//
// Source: alate. Three moves, each kept only where the scenario's objective falls and the legs concerned stay free from
// end to end (World), flat enough and with room for their corners: the best part of the waypoints is found by dynamic
// programming; legs are halved; waypoints are shifted aside and in height by steps that halve (compass search: Kolda,
// Lewis, Torczon 2003). Nothing is lost: the result is never dearer.
#pragma once

#include <array>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/objective.hpp"
#include "space/straight_limits.hpp"

namespace alate {

class TautRoute {
 public:
  /// `world` must outlive this.
  explicit TautRoute(const World& world);

  /// Better places for a free route, first and last the same. The first steps are `step_m` long. Ends where `run` says
  /// so.
  std::vector<Vec3> pull(std::vector<Vec3> places, double step_m, RunContext& run) const;

  double cost(const std::vector<Vec3>& places) const;

 private:
  using Places = std::vector<Vec3>;
  /// To the end of some leg, and where the leg before that begins.
  struct Way {
    double cost = kInfinity;
    std::size_t before = 0;
  };

  /// Cost of a leg that may be flown by itself; infinite of any other.
  double leg_cost(const Vec3& from, const Vec3& to) const;
  bool fits(const Places& places, std::size_t corner) const;
  bool keeps_range(const Places& places) const;

  /// Costs of legs between all places, by from and to.
  std::vector<double> all_legs(const Places& places, RunContext& run) const;
  Way way_over(const Places& places, const std::vector<Way>& ways, std::array<std::size_t, 2> leg,
               double leg_cost) const;
  Places drop(const Places& places, RunContext& run) const;
  Places halve(const Places& places, double longest_m) const;
  void relax(Places& places, double step_m, RunContext& run) const;
  bool shift(Places& places, std::size_t i, double step_m) const;
  bool try_place(Places& places, std::size_t i, const Vec3& place, double& best) const;

  const World& world_;
  Objective objective_;
  StraightLimits limits_;
  double range_m_;
};

}  // namespace alate
