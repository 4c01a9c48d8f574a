// Trail cells in a hash table: for boxes too large for a grid, and for exact points (cells of 1e-4 units).
//
// Departure from eq. (35), which compares real coordinates without saying how: points are the same that round to the
// same 1e-4. They are known to 4e-6 at 40 units (single precision), so that a few in a hundred fall to a neighbour. A
// place is named by 64 mixed bits of its three rounded coordinates; two of a million places share a name with a chance
// of 3e-8. Only changed as a whole, each place alone, so the order of entry does not show.
#pragma once

#include <cmath>
#include <vector>

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"

namespace alate {

class HashCells {
 public:
  explicit HashCells(double cell_m) : per_cell_(1 / cell_m), slots_(kFirstSlots), filter_(kFilterWords) {}

  void find_all(Choices& choices) const {
    for (std::size_t k = 0; k < choices.trail.size(); ++k)
      choices.trail[k] = find(name(choices.x[k], choices.y[k], choices.z[k]));
  }

  /// key = round(coordinate / cell).
  TrailKey name(float x, float y, float z) const {
    const TrailKey mixed = mix(kX * rounded(x) + kY * rounded(y) + kZ * rounded(z));
    return mixed == kEmpty ? 1 : mixed;
  }

  StoredTrail find(TrailKey key) const {
    if ((filter_[word_of(key)] & bit_of(key)) == 0) return 0;
    for (std::size_t i = key & (slots_.size() - 1); slots_[i].key != kEmpty; i = (i + 1) & (slots_.size() - 1))
      if (slots_[i].key == key) return slots_[i].value;
    return 0;
  }

  StoredTrail& at(TrailKey key) {
    if (2 * used_ >= slots_.size()) grow();
    Slot& slot = slot_of(key);
    if (slot.key == kEmpty) {
      slot.key = key;
      filter_[word_of(key)] |= bit_of(key);
      ++used_;
    }
    return slot.value;
  }

  template <class Change>
  void for_each(const Change& change) {
    for (Slot& slot : slots_)
      if (slot.key != kEmpty) change(slot.value);
  }

 private:
  static constexpr TrailKey kEmpty = 0;
  static constexpr TrailKey kX = 0x9E3779B97F4A7C15ULL;
  static constexpr TrailKey kY = 0xC2B2AE3D27D4EB4FULL;
  static constexpr TrailKey kZ = 0x165667B19E3779F9ULL;
  static constexpr std::size_t kFirstSlots = 1024;
  static constexpr std::size_t kFilterWords = 1U << 16U;  ///< 512 KB: stays in the cache, unlike the slots.
  struct Slot {
    TrailKey key = kEmpty;
    StoredTrail value = 0;
  };

  /// floor(value / cell + 0.5), without the call that std::floor is on plain x86-64.
  std::uint64_t rounded(float value) const {
    const double cells = static_cast<double>(value) * per_cell_ + 0.5;
    const auto cut = static_cast<std::int64_t>(cells);
    return static_cast<std::uint64_t>(cut - (cells < static_cast<double>(cut) ? 1 : 0));
  }
  /// The finaliser of SplitMix64.
  static std::uint64_t mix(std::uint64_t z) {
    z += 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  static std::size_t word_of(TrailKey key) { return key >> 48U; }
  static std::uint64_t bit_of(TrailKey key) { return std::uint64_t{1} << ((key >> 42U) % 64); }

  Slot& slot_of(TrailKey key) {
    std::size_t i = key & (slots_.size() - 1);
    while (slots_[i].key != kEmpty && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    std::swap(old, slots_);
    for (const Slot& slot : old)
      if (slot.key != kEmpty) slot_of(slot.key) = slot;
  }

  double per_cell_;
  std::vector<Slot> slots_;
  std::size_t used_ = 0;
  std::vector<std::uint64_t> filter_;  ///< A bit for the first 22 bits of each key: most places are unknown.
};

}  // namespace alate
