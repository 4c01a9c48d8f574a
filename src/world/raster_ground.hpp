// Height of straight legs above bilinear ground: exact, and cheap where the ground is far below.
//
// Method: a leg is cut where PostMap bends it, and each piece is walked cell by cell (Amanatides and Woo 1987). Inside
// a cell the ground under it is a quadratic of the leg's parameter, so its lowest and highest clearance lie at the ends
// or at the vertex: closed form. Blocks of the height pyramid whose bounds cannot matter are jumped over, to the
// very cell that the walk would have reached, so that pruning never changes a bit of the result.
// Cost: one closed form per cell that matters, one bound per block that does not. No allocation.
#pragma once

#include "alate/core/geometry.hpp"
#include "alate/data/height_raster.hpp"
#include "world/height_pyramid.hpp"

namespace alate {

class RasterGround {
 public:
  /// Borrows the raster, which must outlive this.
  explicit RasterGround(const HeightRaster& raster) : raster_(raster), pyramid_(raster) {}

  /// Lowest height of the leg above the ground; -infinity where it leaves the posts or meets unknown ground.
  double clearance(const Segment& leg) const;

  /// Is the leg everywhere at least `floor` and at most `roof` above known ground? Same arithmetic as clearance.
  bool within(const Segment& leg, double floor, double roof) const;

 private:
  template <class Goal>
  bool follow(const Segment& leg, Goal& goal) const;

  const HeightRaster& raster_;
  HeightPyramid pyramid_;
};

}  // namespace alate
