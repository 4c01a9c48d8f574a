// Ways made cheaper by cutting corners and by moving waypoints, every new leg tested in the direction of travel.
//
// OMPL 1.5.2's own shortcutPath tests a pair of points in the order in which they were drawn; where ways differ with
// the direction, as here, most of what it returns cannot be flown. So it is written anew: the whole way is tested from
// the first new leg to the goal, with all altitudes that it allows at once. With altitudes kept at the waypoints hardly
// any corner of a long climb could be cut, since all that follows would have to be lowered with it.
#pragma once

#include <ompl/util/RandomNumbers.h>

#include <vector>

#include "flight_legs.hpp"

namespace alate::peers {

class ShorterWay {
 public:
  ShorterWay(const FlightLegs& legs, Way way);

  const Way& way() const { return way_; }
  /// Without what the altitudes add to the length.
  double cost() const { return total_; }

  /// One attempt each; true if the way is cheaper now.
  bool shortcut(ompl::RNG& random);
  bool perturb(ompl::RNG& random);

 private:
  struct Place {
    std::size_t leg = 0;  ///< Begins at the waypoint of this index.
    double part = 0;      ///< Of the leg; 0: its begin.
  };
  /// What is known at a waypoint.
  struct Passage {
    AltitudeLabel label;
    double cost = 0;  ///< To here, without ascent.
  };
  Place place_at(double cost, ompl::RNG& random) const;
  PlanarPose pose_at(const Place& place) const;
  bool replace(std::size_t first, std::size_t last, const std::vector<PlanarPose>& by);
  double fly(std::size_t first, double most);
  PlanarPose moved(const PlanarPose& from, std::size_t before, std::size_t after, ompl::RNG& random) const;

  const FlightLegs* legs_;
  Way way_;
  std::vector<Passage> passages_;  ///< At each waypoint.
  double total_;
};

}  // namespace alate::peers
