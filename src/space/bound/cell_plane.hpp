// Square cells over an area, numbered row by row from low x, y.
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "alate/data/site.hpp"

namespace alate {

class CellPlane {
 public:
  /// Between two cells: a line along an axis, as a box without width.
  struct Side {
    Box2 line;
    int other = 0;  ///< The cell beyond.
  };

  /// About `most_cells`, but no finer than a raster's.
  CellPlane(const Site& site, const Box2& area, double most_cells) : area_(area) {
    constexpr double kSmallest_m = 1e-3;
    const Vec2 extent = area.max - area.min;
    const auto* raster = std::get_if<HeightRaster>(&site.ground);
    cell_m_ = std::max({std::sqrt(extent.x() * extent.y() / most_cells), extent.maxCoeff() / most_cells,
                        raster != nullptr ? raster->cell_m : kSmallest_m});
    columns_ = std::max(1, static_cast<int>(std::ceil(extent.x() / cell_m_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(extent.y() / cell_m_)));
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int cells() const { return columns_ * rows_; }
  std::size_t size() const { return static_cast<std::size_t>(cells()); }
  double cell_m() const { return cell_m_; }

  Box2 box(int cell) const {
    const Vec2 corner = area_.min + cell_m_ * Vec2(cell % columns_, cell / columns_);
    return {.min = corner, .max = corner + Vec2::Constant(cell_m_)};
  }
  int cell_at(const Vec2& place) const {
    const Vec2 at = (place - area_.min) / cell_m_;
    const int column = std::clamp(static_cast<int>(at.x()), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(at.y()), 0, rows_ - 1);
    return row * columns_ + column;
  }

  /// Calls visit(Side) for those towards high x and high y.
  template <class Visit>
  void for_sides_behind(int cell, const Visit& visit) const {
    const Box2 here = box(cell);
    if (cell % columns_ + 1 < columns_)
      visit(Side{{.min = Vec2(here.max.x(), here.min.y()), .max = here.max}, cell + 1});
    if (cell / columns_ + 1 < rows_)
      visit(Side{{.min = Vec2(here.min.x(), here.max.y()), .max = here.max}, cell + columns_});
  }
  /// For all.
  template <class Visit>
  void for_sides(int cell, const Visit& visit) const {
    const Box2 here = box(cell);
    for_sides_behind(cell, visit);
    if (cell % columns_ > 0) visit(Side{{.min = here.min, .max = Vec2(here.min.x(), here.max.y())}, cell - 1});
    if (cell / columns_ > 0) visit(Side{{.min = here.min, .max = Vec2(here.max.x(), here.min.y())}, cell - columns_});
  }

 private:
  Box2 area_;
  double cell_m_ = 0;
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace alate
