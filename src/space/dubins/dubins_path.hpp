// The shortest way of bounded curvature between two poses in the plane (Dubins 1957).
#pragma once

#include <array>

#include "space/dubins/planar_pose.hpp"

namespace alate {

/// In the order in which ties are broken.
enum class DubinsWord : unsigned char { lsl, rsr, lsr, rsl, lrl, rlr };

/// What is steered on the three pieces of a word.
std::array<Steering, 3> steering_of(DubinsWord word);

/// A way of three pieces, any of which may have no length.
struct DubinsPath {
  PlanarPose start;
  double radius_m = 0;
  DubinsWord word = DubinsWord::lsl;
  std::array<double, 3> lengths_m{};  ///< >= 0; arcs below a full turn.
  double length_m = 0;  ///< As `dubins_length` gives it, to the last bit; the sum of the above to rounding.
};

/// The shortest path that turns on circles of `radius_m` > 0 only. Poses must be finite.
///
/// A turn that would come out just below zero is left out rather than made nearly full, where that moves the end by at
/// most 1e-10 radii plus 16 roundings of the coordinates (dubins_words.hpp). A path has three places where this may
/// happen, so it ends within thrice that of the goal, headings compared on the circle. Beyond it the jumps of Dubins'
/// distance are kept: a goal right beside the start is nearly a full turn away.
DubinsPath shortest_dubins(const PlanarPose& from, const PlanarPose& to, double radius_m);

/// Its length alone. Never below the straight line.
double dubins_length(const PlanarPose& from, const PlanarPose& to, double radius_m);

}  // namespace alate
