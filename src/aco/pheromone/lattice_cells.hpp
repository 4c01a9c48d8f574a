// Trails on a terrain lattice: on its edges, or on its nodes.
//
// Source: Mai et al. 2023 write tau_ij, an edge; the teaching example that their lattice comes from keeps pheromone on
// nodes. Which of the two they used is not known.
#pragma once

#include <array>
#include <vector>

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"
#include "space/terrain_lattice.hpp"

namespace alate {

class LatticeCells {
 public:
  using Node = TerrainLattice::Node;
  enum class On { edges, nodes };
  static constexpr unsigned kRow = TerrainLattice::kRow;

  /// `frame` must outlive this.
  LatticeCells(const LatticeFrame& frame, On on)
      : frame_(&frame),
        on_(on),
        stored_(on == On::edges ? kRow * frame.nodes() : frame.nodes()),
        is_known_(stored_.size() / kRow + 1),
        has_known_(frame.nodes()),
        has_changed_(frame.nodes()) {}

  TrailKey key(TerrainLattice::Edge edge) const {
    return on_ == On::edges ? TrailKey{edge} : TrailKey{frame_->after(edge / kRow, edge % kRow)};
  }

  StoredTrail find(TrailKey key) const { return stored_[key]; }
  StoredTrail& at(TrailKey key) {
    if (!is_known(key)) known_.push_back(key);
    is_known_[key / kRow] |= 1U << (key % kRow);
    mark(key);
    return stored_[key];
  }
  template <class Change>
  void for_each(const Change& change) {
    for (const TrailKey key : known_) change(stored_[key]);
  }

  /// Has it ever been asked for to be changed? A bit for each: fewer places to look at than for what is stored.
  bool is_known(TrailKey key) const { return ((is_known_[key / kRow] >> (key % kRow)) & 1U) != 0; }

  /// What is stored for the moves of a set from a node.
  std::array<StoredTrail, kRow> row(Node node, unsigned moves) const;

  /// Nodes that some known trail leaves; all trails from other nodes are alike.
  const std::vector<Node>& known_rows() const { return known_rows_; }
  /// Those that a trail leaves that was asked for to be changed, since they were last forgotten.
  const std::vector<Node>& changed_rows() const { return changed_rows_; }
  void forget_changes();

 private:
  void mark(TrailKey key);
  void mark_row(Node node);

  const LatticeFrame* frame_;
  On on_;
  std::vector<StoredTrail> stored_;
  std::vector<std::uint32_t> is_known_;
  std::vector<TrailKey> known_;
  std::vector<std::uint8_t> has_known_, has_changed_;
  std::vector<Node> known_rows_, changed_rows_;
};

}  // namespace alate
