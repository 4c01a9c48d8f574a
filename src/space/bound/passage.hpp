// What a flight costs at the least if it passes some place at some altitude.
#pragma once

#include <array>

#include "alate/world/problem.hpp"
#include "space/bound/open_air.hpp"

namespace alate {

/// The way from the start to the place and on to the goal's ball, no shorter than climb and descent need, and the
/// price of both ascents: for each way of estimating it, a convex function of the altitude that is straight between
/// known kinks. The problem must outlive this.
class Passage {
 public:
  explicit Passage(const Problem& problem);

  /// The least over the places of `box`, which may have no width, and the altitudes `open`, of which there are some.
  double price(const Box2& box, const Altitudes& open) const;
  /// Of a flight that is at least so long seen from above.
  double least(double planar_m) const;
  bool ends_at(const Box2& box, const Altitudes& open) const;

 private:
  struct Tilt {
    explicit Tilt(double slope);
    double cosine, sine;
  };
  struct Ways {
    double from_start_m = 0;
    double to_goal_m = 0;
  };
  std::array<double, 3> prices(const Ways& ways, double z) const;

  const ObjectiveSpec& weights_;
  const Mission& mission_;
  SlopeLimits slopes_;
  Tilt climb_, descent_;
  Altitudes goal_;
};

}  // namespace alate
