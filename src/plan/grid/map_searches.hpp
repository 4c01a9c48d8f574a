// Searches that are made for a map, kept from one query to the next.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "alate/world/world.hpp"
#include "search/grid/bit_grid.hpp"
#include "search/voxel/voxel_bits.hpp"

namespace alate {

inline const HeightGrid& map_of(const Site& site, const BitGrid* /*cells*/) { return *site.grid; }
inline const VoxelGrid& map_of(const Site& site, const VoxelBits* /*cells*/) { return *site.voxels; }

/// Lends searches on the grid of a world, or its voxels. Those that came back are lent again while the world is the
/// same, so that a query neither reads the map nor allocates; they keep the world alive. Any thread may borrow: each
/// gets its own.
template <class Search, class Cells>
class MapSearches {
 public:
  struct Item {
    explicit Item(const World& w)
        : world(w), cells(map_of(w.site(), static_cast<const Cells*>(nullptr))), search(cells) {}
    Item(const Item&) = delete;
    Item& operator=(const Item&) = delete;

    World world;
    Cells cells;
    Search search;
  };
  using Loan = std::unique_ptr<Item>;

  Loan borrow(const World& world) {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty() && &idle_.back()->world.site() != &world.site()) idle_.clear();
    if (idle_.empty()) return std::make_unique<Item>(world);
    Loan loan = std::move(idle_.back());
    idle_.pop_back();
    return loan;
  }
  void give_back(Loan loan) {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty() && &idle_.back()->world.site() != &loan->world.site()) idle_.clear();
    idle_.push_back(std::move(loan));
  }

 private:
  std::mutex mutex_;
  std::vector<Loan> idle_;  ///< All of one world.
};

}  // namespace alate
