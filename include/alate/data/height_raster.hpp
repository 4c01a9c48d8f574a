// Ground heights as posts on a grid, and the way from frame metres to post coordinates.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/core/frame.hpp"
#include "alate/core/geometry.hpp"

namespace alate {

/// Frame metres -> post coordinates (column, row), where (0, 0) is the first post and whole numbers are posts.
/// A raster in the frame's own CRS is mapped by its exact affine. Any other is mapped by a lattice of exactly
/// projected knots: squares cut into two triangles by the diagonal from low x, y to high x, y, the map being affine
/// in each. Its spacing is chosen so that the error stays below 0.001 post (checked at the middle of every square
/// and of every side when it is built). So a straight leg maps to straight pieces, cut where it changes triangle.
class PostMap {
 public:
  /// Row-major 2x3 affine: column = a[0] + a[1] x + a[2] y, row = a[3] + a[4] x + a[5] y.
  static PostMap affine(const std::array<double, 6>& coefficients);
  /// `knots` are post coordinates at `area.min + (i, j) * spacing_m`, row-major with i fastest.
  static PostMap lattice(const Box2& area, double spacing_m, int columns, std::vector<Vec2> knots);

  /// NaN outside the area of a lattice.
  Vec2 operator()(const Vec2& xy) const {
    if (knots_.empty()) return through_affine(xy);
    return area_.contains(xy) ? interpolate(triangle_at(xy)) : Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  /// The leg from `a` to `b` maps to a straight line from parameter `t` in [0, 1) to the one returned, which is
  /// greater than t; 1 at the end. Cutting a leg there makes every piece exactly straight.
  double straight_until(const Vec2& a, const Vec2& b, double t) const {
    if (knots_.empty() || (t == 0 && triangle_at(a).same_as(triangle_at(b)))) return 1;
    return next_bend(a, b, t);
  }

 private:
  /// A place in a triangle of the lattice: square (i, j), and within it u right and v up, in [0, 1].
  struct Place {
    int i, j;
    double u, v;
    bool below_diagonal() const { return u >= v; }
    bool same_as(const Place& p) const { return i == p.i && j == p.j && below_diagonal() == p.below_diagonal(); }
  };

  Vec2 through_affine(const Vec2& p) const {
    return {affine_[0] + affine_[1] * p.x() + affine_[2] * p.y(), affine_[3] + affine_[4] * p.x() + affine_[5] * p.y()};
  }
  Place triangle_at(const Vec2& xy) const {
    const Vec2 at = (xy - area_.min) * per_spacing_;
    const int i = std::min(static_cast<int>(at.x()), columns_ - 2);
    const int j = std::min(static_cast<int>(at.y()), rows_ - 2);
    return {i, j, at.x() - i, at.y() - j};
  }
  /// Along the first side by the larger of u and v, then along the second by the smaller: no branch to guess.
  Vec2 interpolate(const Place& p) const {
    const Vec2* low = knots_.data() + static_cast<std::ptrdiff_t>(p.j) * columns_ + p.i;
    const Vec2* high = low + columns_;
    const Vec2* corner = p.below_diagonal() ? low + 1 : high;
    return *low + std::max(p.u, p.v) * (*corner - *low) + std::min(p.u, p.v) * (high[1] - *corner);
  }
  double next_bend(const Vec2& a, const Vec2& b, double t) const;

  std::array<double, 6> affine_{};
  Box2 area_{};
  double per_spacing_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Vec2> knots_;  ///< Empty for an affine map.
};

/// The ground between four posts is bilinear. A cell with a void post is unknown ground, never zero.
struct HeightRaster {
  int columns = 0;
  int rows = 0;
  std::vector<float> posts;  ///< Row-major, metres above `datum`; NaN where the source has no data.
  PostMap map;
  Box2 area;          ///< Frame rectangle around all posts.
  double cell_m = 0;  ///< Mean distance between neighbouring posts in the frame.
  std::string name;   ///< File name without folder.
  std::string crs;    ///< As the source names it.
  std::string datum;  ///< Vertical datum: "EGM96 height", or "not stated (taken as mean sea level)".
  std::size_t voids = 0;

  float post(int column, int row) const {
    return posts[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
  /// Are these post coordinates within the outermost posts?
  bool covers(const Vec2& post_xy) const {
    return post_xy.x() >= 0 && post_xy.y() >= 0 && post_xy.x() <= columns - 1 && post_xy.y() <= rows - 1;
  }
  /// Bilinear height at frame position `xy`: nothing outside the posts, NaN on unknown ground.
  std::optional<double> height(const Vec2& xy) const;
};

/// Reads band 1 of a raster file in any CRS. Faults go to `faults` (field `terrain.dem`) and nothing is
/// returned: missing, empty, truncated, no CRS, more than the limit of cells, a /vsi path other than /vsizip,
/// unknown driver, no geotransform, heights that are complex, in no unit of length or above the ellipsoid.
/// Heights in feet are brought to metres. Posts that no ground on Earth has (below -12 000 m) are voids.
/// In a local frame, or with a frame CRS equal to the raster's, posts are mapped exactly.
std::optional<HeightRaster> read_height_raster(const std::string& file, const Frame& frame, std::vector<Fault>& faults);

}  // namespace alate
