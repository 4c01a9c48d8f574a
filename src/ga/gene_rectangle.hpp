// The rectangle about the line from start to goal over which the genes of Zhou et al. 2020 are drawn.
#pragma once

#include <vector>

#include "alate/core/stream.hpp"
#include "space/correction_graph.hpp"

namespace alate {

/// As long as the line from start to goal and cut across into cells of equal length. Genes are drawn as coordinates,
/// heights do not count; a coordinate stands for the nearest unused point of its cell. Gaps of the paper: its width,
/// its number of cells and what happens in a cell without an unused point are not said; here the nearest unused point
/// of the whole rectangle is taken then.
class GeneRectangle {
 public:
  using Node = CorrectionGraph::Node;

  /// Along the line and to its left, metres.
  struct Coordinate {
    double along_m = 0;
    double left_m = 0;
  };

  GeneRectangle(const CorrectionGraph& graph, double width_m, std::size_t cells);

  /// Points inside: no more genes can be had.
  std::size_t points() const { return points_; }
  Coordinate draw(Stream& stream) const;
  Coordinate draw_in(std::size_t cell, Stream& stream) const;
  Coordinate at(Node point) const;
  bool contains(const Coordinate& place) const;
  std::size_t cell_of(const Coordinate& place) const;

  /// The nearest point of the cell of `place` that is not in `used`; there must be one in the rectangle.
  Node nearest_unused(const Coordinate& place, const std::vector<Node>& used) const;

 private:
  struct Place {
    Coordinate at;
    Node node = 0;
  };

  const CorrectionGraph& graph_;
  Vec2 start_;
  Vec2 direction_ = {1, 0};
  double length_m_ = 0;
  double width_m_ = 0;
  std::size_t points_ = 0;
  std::vector<std::vector<Place>> cells_;
};

}  // namespace alate
