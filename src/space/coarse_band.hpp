// Ground, ceiling and threat on coarse cells: what the guidance over terrain is computed on.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "alate/core/run_context.hpp"
#include "alate/world/world.hpp"
#include "space/candidates.hpp"

namespace alate {

/// Square cells over the ground's area; without ground, over start, goal and threats, a cell below and above start
/// and goal. Floor and ceiling are optimistic: the lowest and highest that any sample of
/// the cell allows. Cells without known ground, or where the band is empty, are blocked.
class CoarseBand {
 public:
  static constexpr int kCells = 12000;      ///< At most about so many, whatever the area.
  static constexpr int kLayers = 6;         ///< Altitude samples per cell, floor to ceiling.
  static constexpr int kSamplesAcross = 4;  ///< Ground samples along a cell's side.

  /// No cell is narrower than `least_m`. Stops early, leaving cells blocked or without threat, when `run` says so.
  CoarseBand(const World& world, RunContext& run, double least_m = 0);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  double cell_m() const { return cell_m_; }
  Vec2 center(std::size_t cell) const;
  /// Bilinear between the middles of the four cells around `xy`; cells whose value is infinite are left out, and
  /// infinite where all are. value(cell) is what a cell says.
  template <class Value>
  double blend(const Vec2& xy, const Value& value) const {
    const Vec2 place = (xy - area_.min) / cell_m_ - Vec2(0.5, 0.5);
    const Vec2 corner(std::floor(place.x()), std::floor(place.y()));
    const Vec2 part = place - corner;
    double sum = 0;
    double weights = 0;
    for (int dj = 0; dj < 2; ++dj) {
      for (int di = 0; di < 2; ++di) {
        const int i = std::clamp(static_cast<int>(corner.x()) + di, 0, columns_ - 1);
        const int j = std::clamp(static_cast<int>(corner.y()) + dj, 0, rows_ - 1);
        const double weight = (di == 0 ? 1 - part.x() : part.x()) * (dj == 0 ? 1 - part.y() : part.y());
        const int cell = j * columns_ + i;
        const double here = value(static_cast<std::size_t>(cell));
        if (std::isinf(here) || weight <= 0) continue;
        sum += weight * here;
        weights += weight;
      }
    }
    return weights > 0 ? sum / weights : std::numeric_limits<double>::infinity();
  }

  bool blocked(std::size_t cell) const { return !(floor_[cell] <= ceiling_[cell]); }
  double floor_m(std::size_t cell) const { return floor_[cell]; }
  double layer_m(std::size_t cell) const { return (ceiling_[cell] - floor_[cell]) / (kLayers - 1); }
  double altitude(std::size_t cell, int layer) const { return floor_[cell] + layer * layer_m(cell); }
  /// Looks at the threats anew where `threat`, which `world` has and the world before had not, may reach. Calls
  /// changed(cell) for every such cell.
  template <class Changed>
  void add_threat(const World& world, const Threat& threat, const Changed& changed) {
    const double reach = std::max(threat.radius_m, threat.core_m) + cell_m_;
    for (std::size_t cell = 0; cell < size(); ++cell) {
      if (blocked(cell) || (center(cell) - threat.center.head<2>()).squaredNorm() > reach * reach) continue;
      sample_threat(world, cell);
      changed(cell);
    }
  }

  /// Exposure per metre; infinite in a core.
  double threat(std::size_t cell, int layer) const { return threat_[cell * kLayers + static_cast<std::size_t>(layer)]; }

 private:
  void sample_ground(const World& world, std::size_t cell);
  /// Gives the band an upper end where no ceiling does: a cell above the highest floor, start and goal.
  void close_upwards(const Site& site);
  void sample_threat(const World& world, std::size_t cell);

  Box2 area_;
  double cell_m_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<double> floor_, ceiling_, threat_;
};

}  // namespace alate
