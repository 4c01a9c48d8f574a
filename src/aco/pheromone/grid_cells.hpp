// Trail cells in a dense grid over the box that routes can reach.
//
// Places outside the box share its outermost cells: no route that arrives comes there. Memory that is never touched is
// never paid for (calloc).
#pragma once

#include <cassert>
#include <cstdlib>
#include <memory>
#include <optional>

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"

namespace alate {

class GridCells {
 public:
  static constexpr double kMostBytes = 64e6;

  /// Nothing if the box has too many cells of this size.
  static std::optional<GridCells> over(const ReachBox& box, float cell_m);

  void find_all(Choices& choices) const;
  TrailKey name(float x, float y, float z) const { return static_cast<std::uint32_t>(layout_.index(x, y, z)); }
  StoredTrail find(TrailKey key) const { return cells_[key]; }
  StoredTrail& at(TrailKey key) {
    if (cells_[key] == 0) known_.push_back(key);
    return cells_[key];
  }
  template <class Change>
  void for_each(const Change& change) {
    for (const TrailKey key : known_) change(cells_[key]);
  }

 private:
  // Not a vector: only calloc leaves pages untouched until an ant comes there.
  // NOLINTBEGIN(cppcoreguidelines-no-malloc, modernize-avoid-c-arrays)
  struct Free {
    void operator()(StoredTrail* cells) const { std::free(cells); }
  };
  using Cells = std::unique_ptr<StoredTrail[], Free>;
  static Cells zeroed(std::size_t count) {
    return Cells(static_cast<StoredTrail*>(std::calloc(count, sizeof(StoredTrail))));
  }
  // NOLINTEND(cppcoreguidelines-no-malloc, modernize-avoid-c-arrays)
  struct Layout {
    struct Axis {
      float from = 0;
      float per_cell = 0;
      float last = 0;  ///< Greatest index.

      std::int32_t index(float value) const {
        const float cell = (value - from) * per_cell;
        const float above = cell > 0 ? cell : 0;
        return static_cast<std::int32_t>(above < last ? above : last);
      }
    };
    Axis x, y, z;
    std::int32_t columns = 0;
    std::int32_t layer = 0;  ///< Cells of one layer.

    std::int32_t index(float px, float py, float pz) const {
      return x.index(px) + columns * y.index(py) + layer * z.index(pz);
    }
  };
  GridCells() = default;

  Layout layout_;
  Cells cells_;
  std::vector<TrailKey> known_;
};

}  // namespace alate
