// Ways made cheaper by cutting corners and by moving waypoints, every new leg tested in the direction of travel.
//
// OMPL 1.5.2's own shortcutPath tests a pair of points in the order in which they were drawn; where ways differ with
// the direction, as here, most of what it returns cannot be flown. So it is written anew: motion and cost are tested
// from the earlier point to the later one, and the two rests of legs that were split are tested again.
#pragma once

#include <ompl/util/RandomNumbers.h>

#include <vector>

#include "flight_legs.hpp"

namespace alate::peers {

class ShorterWay {
 public:
  ShorterWay(const FlightLegs& legs, Way way);

  const Way& way() const { return way_; }
  double cost() const { return total_; }

  /// One attempt each; true if the way is cheaper now.
  bool shortcut(ompl::RNG& random);
  bool perturb(ompl::RNG& random);
  /// The altitudes that the ground track allows at least ascent.
  void settle();

 private:
  struct Place {
    std::size_t leg = 0;  ///< Begins at the waypoint of this index.
    double part = 0;      ///< Of the leg; 0: its begin.
  };
  Place draw_place(ompl::RNG& random) const;
  bool replace(std::size_t first, std::size_t last, const Way& by);
  Waypoint moved(const Waypoint& from, std::size_t before, std::size_t after, ompl::RNG& random) const;
  void note_costs();

  const FlightLegs* legs_;
  Way way_;
  std::vector<double> costs_;  ///< Of the leg from each waypoint but the last.
  double total_ = 0;
};

}  // namespace alate::peers
