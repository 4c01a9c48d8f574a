// Which cells of a map a straight flight passes, exactly, in the plane or in space; independent of the planners'
// spaces.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "alate/check/check.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Numbers of a cell along each axis from the lower corner of the map, so that a height grid's row 0 is the last.
template <int axes>
using CellAt = std::array<int, static_cast<std::size_t>(axes)>;

template <int axes>
using CellPlace = Eigen::Matrix<double, axes, 1>;

/// A height grid as a map of squares.
struct FlatCells {
  static constexpr int kAxes = 2;
  const HeightGrid& grid;

  double cell_m() const { return grid.cell_m; }
  Vec2 origin() const { return grid.origin; }
  CellAt<kAxes> size() const { return {grid.columns, grid.rows}; }
  int row(const CellAt<kAxes>& cell) const { return grid.rows - 1 - cell[1]; }
  bool contains(const CellAt<kAxes>& cell) const { return grid.contains(cell[0], row(cell)); }
  bool is_free(const CellAt<kAxes>& cell) const { return contains(cell) && !grid.blocked_at(cell[0], row(cell)); }
};

/// A voxel map as one of cubes.
struct SpaceCells {
  static constexpr int kAxes = 3;
  const VoxelGrid& grid;

  double cell_m() const { return grid.cell_m; }
  static Vec3 origin() { return Vec3::Zero(); }
  const CellAt<kAxes>& size() const { return grid.size(); }
  bool contains(const CellAt<kAxes>& cell) const { return grid.contains(cell); }
  bool is_free(const CellAt<kAxes>& cell) const { return grid.is_free(cell); }
};

/// Flight between two sides of cells. It lies in one cell, or along what several have in common: a side of two, in
/// space an edge of four. A flight of no length may lie on a corner. Cells may be outside the map.
template <int axes>
struct Stretch {
  std::array<CellAt<axes>, std::size_t{1} << axes> held{};
  std::size_t count = 0;
  CellPlace<axes> begin = CellPlace<axes>::Zero();
  CellPlace<axes> middle = CellPlace<axes>::Zero();

  std::span<const CellAt<axes>> cells() const { return {held.data(), count}; }
};

/// Follows a route over `map`. Steps within kRoundingNoise of where it stands are joined to the next one, so that a
/// chain of them hides nothing. Places within kRoundingNoise of a side of cells lie on it.
template <class Map>
class CellPassage {
 public:
  static constexpr int kAxes = Map::kAxes;
  using Place = CellPlace<kAxes>;

  CellPassage(Map map, const Place& start) : map_(map), at_(start - map.origin()) {}

  /// The stretches of the straight flight to `place`, in order; parts more than a cell outside the map left out. At
  /// most the sum of the map's sides and 3 for each axis.
  std::vector<Stretch<kAxes>> advance(const Place& place);
  /// Where it stands.
  Stretch<kAxes> here() const { return stretch(at_, at_); }

 private:
  /// Between places counted from the map's origin.
  Stretch<kAxes> stretch(const Place& begin, const Place& end) const;
  Place extent() const;
  std::optional<std::pair<Place, Place>> clipped(const Place& from, const Place& to) const;
  std::vector<double> crossings(const Place& from, const Place& to, double length) const;

  Map map_;
  Place at_;  ///< From the map's origin.
};

/// A free cell of the stretch; nothing if none is.
template <class Map>
const CellAt<Map::kAxes>* free_cell(const Map& map, const Stretch<Map::kAxes>& stretch) {
  const auto cells = stretch.cells();
  const auto found = std::ranges::find_if(cells, [&](const auto& cell) { return map.is_free(cell); });
  return found == cells.end() ? nullptr : &*found;
}

/// Does the stretch lie in blocked cells of the map only?
template <class Map>
bool is_blocked(const Map& map, const Stretch<Map::kAxes>& stretch) {
  const auto inside = [&](const auto& cell) { return map.contains(cell); };
  return free_cell(map, stretch) == nullptr && std::ranges::any_of(stretch.cells(), inside);
}

/// Are all cells of the box between two cells free that touch each other or are the same?
template <class Map>
bool connects(const Map& map, const CellAt<Map::kAxes>& from, const CellAt<Map::kAxes>& to) {
  for (std::size_t axis = 0; axis < from.size(); ++axis)
    if (std::abs(from.at(axis) - to.at(axis)) > 1) return false;
  for (unsigned corner = 0; corner < 1U << from.size(); ++corner) {
    auto cell = from;
    for (std::size_t axis = 0; axis < from.size(); ++axis)
      if (((corner >> axis) & 1U) != 0) cell.at(axis) = to.at(axis);
    if (!map.is_free(cell)) return false;
  }
  return true;
}

/// May flight go on from one stretch to the next, where they touch: from a free cell to itself, to a free neighbour
/// across a side, or across an edge or corner if all cells around it that lie between the two are free as well (no
/// corner cutting: Yin et al. 2021, Sturtevant 2012, Brewer and Sturtevant 2018).
template <class Map>
bool connects(const Map& map, const Stretch<Map::kAxes>& from, const Stretch<Map::kAxes>& to) {
  return std::ranges::any_of(from.cells(), [&](const auto& a) {
    return std::ranges::any_of(to.cells(), [&](const auto& b) { return connects(map, a, b); });
  });
}

template <class Map>
auto CellPassage<Map>::extent() const -> Place {
  Place extent;
  for (int axis = 0; axis < kAxes; ++axis) extent[axis] = map_.size().at(static_cast<std::size_t>(axis));
  return extent;
}

template <class Map>
Stretch<CellPassage<Map>::kAxes> CellPassage<Map>::stretch(const Place& begin, const Place& end) const {
  const Place middle = (begin + end) / 2;
  Stretch<kAxes> result{.begin = map_.origin() + begin, .middle = map_.origin() + middle};
  const Place farthest = extent() + Place::Constant(2);
  const Place place = (middle / map_.cell_m()).cwiseMax(-2).cwiseMin(farthest);
  const double slack = kRoundingNoise / map_.cell_m();
  result.held[0] = {};
  result.count = 1;
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double side = std::round(place[axis]);
    const bool beside = std::abs(place[axis] - side) <= slack;  // one cell, or the two beside a side
    const int last = static_cast<int>(beside ? side : std::floor(place[axis]));
    for (std::size_t i = 0; i < result.count; ++i) result.held.at(i).at(a) = last;
    if (!beside) continue;
    for (std::size_t i = 0; i < result.count; ++i) {
      result.held.at(result.count + i) = result.held.at(i);
      result.held.at(i).at(a) = last - 1;
    }
    result.count *= 2;
  }
  return result;
}

/// The part of a flight that is not more than a cell outside the map.
template <class Map>
auto CellPassage<Map>::clipped(const Place& from, const Place& to) const -> std::optional<std::pair<Place, Place>> {
  const Place delta = to - from;
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < kAxes; ++axis) {
    const double low = -map_.cell_m();
    const double high = (extent()[axis] + 1) * map_.cell_m();
    if (delta[axis] == 0) {
      if (from[axis] < low || from[axis] > high) return std::nullopt;
      continue;
    }
    const double at_low = (low - from[axis]) / delta[axis];
    const double at_high = (high - from[axis]) / delta[axis];
    enter = std::max(enter, std::min(at_low, at_high));
    leave = std::min(leave, std::max(at_low, at_high));
  }
  if (enter > leave) return std::nullopt;
  return std::pair<Place, Place>{from + enter * delta, from + leave * delta};
}

/// Distances from the begin of a flight of `length` at which it crosses sides of cells, sorted, and its end.
template <class Map>
std::vector<double> CellPassage<Map>::crossings(const Place& from, const Place& to, double length) const {
  std::vector<double> crossings;
  const double cell_m = map_.cell_m();
  for (int axis = 0; axis < kAxes; ++axis) {
    const double a = from[axis];
    const double b = to[axis];
    if (a == b) continue;
    const int last = static_cast<int>(std::floor(std::max(a, b) / cell_m));
    for (int side = static_cast<int>(std::ceil(std::min(a, b) / cell_m)); side <= last; ++side)
      crossings.push_back(std::clamp((side * cell_m - a) / (b - a), 0.0, 1.0) * length);
  }
  std::ranges::sort(crossings);
  crossings.push_back(length);
  return crossings;
}

template <class Map>
std::vector<Stretch<CellPassage<Map>::kAxes>> CellPassage<Map>::advance(const Place& place) {
  const Place to = place - map_.origin();
  if ((to - at_).norm() <= kRoundingNoise) return {};
  const auto part = clipped(at_, to);
  at_ = to;
  if (!part) return {};
  const auto& [a, b] = *part;
  const double length = (b - a).norm();
  std::vector<Stretch<kAxes>> stretches;
  double begin = 0;
  for (const double end : crossings(a, b, length)) {
    if (end - begin <= kRoundingNoise) continue;
    stretches.push_back(stretch(a + (b - a) * (begin / length), a + (b - a) * (end / length)));
    begin = end;
  }
  return stretches;
}

}  // namespace alate
