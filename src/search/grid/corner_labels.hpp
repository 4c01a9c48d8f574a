// What every corner of cells costs to reach, forgotten between queries without clearing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace alate {

/// Lengths are in cell sides. A label of an earlier query counts as none.
class CornerLabels {
 public:
  using Corner = std::uint32_t;

  explicit CornerLabels(std::size_t corners) : labels_(corners) {}

  void begin_query() {
    if (++query_ != 0) return;
    std::ranges::fill(labels_, Label{});
    query_ = 1;
  }
  /// Infinite for a corner that was not reached.
  double length(Corner corner) const {
    const Label& label = labels_[corner];
    return label.query == query_ ? label.length : std::numeric_limits<double>::infinity();
  }
  void set(Corner corner, double length, Corner parent) { labels_[corner] = {length, query_, parent}; }
  /// Of a corner that was reached.
  Corner parent(Corner corner) const { return labels_[corner].parent; }

 private:
  struct Label {
    double length = 0;
    std::uint32_t query = 0;
    Corner parent = 0;
  };

  std::vector<Label> labels_;
  std::uint32_t query_ = 0;
};

}  // namespace alate
