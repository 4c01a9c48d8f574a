// The labels of each node that no other of the node is as good as, as staircases in one pool.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "space/correction_graph.hpp"

namespace alate {

/// At each node lengths rise and errors fall. A staircase that outgrows its room moves to twice as much at the end of
/// the pool.
class LabelStairs {
 public:
  struct Step {
    double length_m = 0;
    double error = 0;
    std::uint32_t label = 0;
  };

  explicit LabelStairs(std::size_t nodes) : rooms_(nodes) {}

  /// Is there a label no longer and with no more error?
  bool dominates(CorrectionGraph::Node node, double length_m, double error) const {
    const std::span<const Step> steps = of(node);
    const auto after = std::ranges::upper_bound(steps, length_m, {}, &Step::length_m);
    return after != steps.begin() && std::prev(after)->error <= error;
  }

  /// Puts in a step that is not dominated and calls out(label) for each label that it dominates.
  template <class Out>
  void insert(CorrectionGraph::Node node, const Step& step, Out&& out) {
    if (rooms_[node].size == rooms_[node].capacity) grow(rooms_[node]);
    const std::span<Step> steps = of(node);
    const auto first = std::ranges::lower_bound(steps, step.length_m, {}, &Step::length_m);
    auto last = first;
    for (; last != steps.end() && last->error >= step.error; ++last) out(last->label);
    if (first == last)
      std::move_backward(first, steps.end(), steps.end() + 1);
    else
      std::move(last, steps.end(), first + 1);
    *first = step;
    rooms_[node].size = static_cast<std::uint32_t>(steps.size() + 1 - static_cast<std::size_t>(last - first));
  }

 private:
  struct Room {
    std::uint32_t first = 0;
    std::uint32_t size = 0;
    std::uint32_t capacity = 0;
  };

  std::span<const Step> of(CorrectionGraph::Node node) const {
    return std::span(pool_).subspan(rooms_[node].first, rooms_[node].size);
  }
  std::span<Step> of(CorrectionGraph::Node node) {
    return std::span(pool_).subspan(rooms_[node].first, rooms_[node].size);
  }
  void grow(Room& room) {
    const auto first = static_cast<std::uint32_t>(pool_.size());
    const std::uint32_t capacity = std::max(4U, 2 * room.capacity);
    pool_.resize(pool_.size() + capacity);
    std::copy_n(pool_.begin() + room.first, room.size, pool_.begin() + first);
    room = {first, room.size, capacity};
  }

  std::vector<Room> rooms_;
  std::vector<Step> pool_;
};

}  // namespace alate
