// Lowest and highest height of a straight piece of flight above the ground, independent of the planners' World.
#pragma once

#include <optional>

#include "alate/data/height_raster.hpp"
#include "alate/data/peaks.hpp"
#include "alate/data/site.hpp"

namespace alate {

struct HeightAt {
  double height_m = 0;
  Vec3 where;
};

/// Nothing where no part of the piece is over known ground.
struct HeightRange {
  std::optional<HeightAt> lowest;
  std::optional<HeightAt> highest;
  std::optional<Vec3> unknown;  ///< A place over unknown ground.

  void include(double height_m, const Vec3& where);
  void include(const HeightRange& other);
};

/// Part of the segment over the rectangle; nothing if it misses it.
std::optional<Segment> clipped(const Segment& segment, const Box2& box);

/// Exact along bilinear ground: walks the grid cells under the piece and takes the extremes of the quadratic
/// height in each, at its ends and its vertex. Parts outside the posts do not count. Cost: cells under the piece.
HeightRange height_range(const HeightRaster& raster, const Segment& piece);

/// Best-first bisection with the ground's greatest slope as Lipschitz bound, until the extreme is known to
/// 0.05 m. The lowest is never above the truth, the highest never below it. After 200 000 bisections (only where
/// the ground is absurdly steep) the bound reached so far stands, which keeps it on the safe side.
HeightRange height_range(const PeakGround& peaks, const Segment& piece);

/// Of whichever ground the site has; empty without any.
HeightRange height_range(const Site& site, const Segment& piece);

}  // namespace alate
