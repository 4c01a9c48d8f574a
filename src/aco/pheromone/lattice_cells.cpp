#include "aco/pheromone/lattice_cells.hpp"

#include <algorithm>
#include <bit>

namespace alate {

std::array<StoredTrail, LatticeCells::kRow> LatticeCells::row(Node node, unsigned moves) const {
  std::array<StoredTrail, kRow> row{};
  if (on_ == On::edges) {
    std::copy_n(&stored_[std::size_t{kRow} * node], kRow, row.begin());
    return row;
  }
  for (; moves != 0; moves &= moves - 1) {
    const auto move = static_cast<unsigned>(std::countr_zero(moves));
    row[move] = stored_[frame_->after(node, move)];
  }
  return row;
}

/// A trail on a node is one of all moves that lead to it.
void LatticeCells::mark(TrailKey key) {
  if (on_ == On::edges) {
    mark_row(static_cast<Node>(key / kRow));
    return;
  }
  const auto node = static_cast<Node>(key);
  const LatticeFrame::Place to = frame_->place(node);
  for (const LatticeFrame::Shift& shift : frame_->shifts()) {
    const LatticeFrame::Place from{to.plane - 1, to.side - shift.side, to.height - shift.height};
    const bool lies_inside = from.plane >= 0 && from.side >= 0 && from.side < frame_->columns() && from.height >= 0 &&
                             from.height < frame_->levels();
    if (lies_inside) mark_row(frame_->node(from));
  }
}

void LatticeCells::mark_row(Node node) {
  if (has_known_[node] == 0) known_rows_.push_back(node);
  if (has_changed_[node] == 0) changed_rows_.push_back(node);
  has_known_[node] = has_changed_[node] = 1;
}

void LatticeCells::forget_changes() {
  for (const Node node : changed_rows_) has_changed_[node] = 0;
  changed_rows_.clear();
}

}  // namespace alate
