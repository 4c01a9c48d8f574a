// Legs between states of a Dubins flight, as OMPL is given them: our own curves and our own exact test.
//
// A state is a pose and an altitude. A leg is the shortest Dubins path between two poses; it can be flown if any
// altitude profile between the two altitudes keeps band, cores, climb and descent. This grants more than straight
// profiles would, in particular in narrow bands.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/world/problem.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/flight/flight_cost.hpp"
#include "space/objective.hpp"

namespace alate::peers {

struct Waypoint {
  PlanarPose pose;
  double z = 0;
};

/// From the start to the goal.
using Way = std::vector<Waypoint>;

class FlightLegs {
 public:
  /// `problem` must outlive this.
  explicit FlightLegs(const Problem& problem);

  const BandWalk& band() const { return band_; }
  const FlightEnd& end() const { return end_; }
  const Mission& mission() const { return mission_; }
  const Box2& area() const { return area_; }
  double radius_m() const { return band_.radius_m(); }

  Track track(const PlanarPose& from, const PlanarPose& to) const;
  bool can_fly(const Waypoint& from, const Waypoint& to) const;
  /// Length in space, climb between the ends, exposure as on a straight profile.
  double cost(const Waypoint& from, const Waypoint& to) const;
  /// No leg between the two costs less.
  double least_cost(const Waypoint& from, const Waypoint& to) const;
  /// Nor does any way from here to the goal.
  double least_cost_to_goal(const Waypoint& from) const;
  /// No way that costs as much is longer over the ground.
  double most_length(double cost) const { return cost / weights_.length; }

  /// The altitudes that the band allows at a place; nothing where the ground is unknown or they are none.
  std::optional<std::pair<double, double>> altitudes(const PlanarPose& pose) const;
  /// The pose of a leg `part` of its length from its begin.
  PlanarPose pose_on(const PlanarPose& from, const PlanarPose& to, double part) const;
  /// Is the air behind the state open, as far as a turn needs it?
  bool can_approach(const Waypoint& to) const;
  /// The nearest pose in the goal's ball, by any heading.
  std::optional<PlanarPose> shot_to_goal(const PlanarPose& from) const;

  /// Onward over a leg whatever the altitudes: its cost without ascent, infinite if no altitude is left.
  double advance(const PlanarPose& from, const PlanarPose& to, AltitudeLabel& label) const;
  /// Cost of the ascent to the goal's ball; infinite if no altitude leads into it.
  double arrive(const AltitudeLabel& label) const;

  /// The way with the least length and ascent that its ground track allows; nothing if it cannot be flown.
  std::optional<Route> route(const Way& way) const;
  double cost(const Route& route) const { return objective_.route_cost(route); }

 private:
  Track track_of(const Way& way) const;

  BandWalk band_;
  FlightCost flight_cost_;
  Objective objective_;
  ObjectiveSpec weights_;
  Mission mission_;
  FlightEnd end_;
  Box2 area_;
};

}  // namespace alate::peers
