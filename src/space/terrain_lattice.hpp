// The terrain lattice: from plane to plane towards the goal, up to 25 moves a node.
//
// Source: Mai et al. 2023, sections 1 and 2. Nodes, free moves and costs stand in arrays before the first ant sets out
// (lattice_frame.hpp, lattice_moves.hpp, lattice_score.hpp, which also say what is the paper's).
#pragma once

#include <optional>
#include <span>

#include "space/lattice_score.hpp"

namespace alate {

struct LatticeOptions {
  LatticeSteps steps;
  LatticeRules rules;
  TerrainScore score;
};

/// A string of moves from the start to the last plane, and the leg that joins the goal.
struct LatticeFlight {
  double score = kInfinity;  ///< Infinite unless it arrives.
  double length_m = 0;
  bool is_route = false;  ///< Free from end to end, and no longer than the aircraft's range.
  LatticeFaults faults;   ///< Constraints broken on it.
};

/// Immutable. World must outlive it.
class TerrainLattice {
 public:
  using Node = LatticeFrame::Node;
  static constexpr unsigned kRow = 32;  ///< Length of a row of tables by move.
  static constexpr unsigned kFirst = LatticeFrame::kFirst;

  /// Stops early where `run` says so.
  TerrainLattice(const World& world, LatticeFrame frame, const LatticeOptions& options, RunContext& run);
  TerrainLattice(const TerrainLattice&) = delete;  // its parts know each other
  TerrainLattice& operator=(const TerrainLattice&) = delete;

  const LatticeFrame& frame() const { return frame_; }
  const LatticeMoves& moves() const { return moves_; }
  const LatticeScore& score() const { return score_; }

  /// Moves until the last plane; the last leg comes after them.
  std::size_t walk_length() const { return static_cast<std::size_t>(frame_.planes()) - 1; }

  /// A move from a node: kRow * node + move.
  using Edge = std::uint32_t;

  /// Edges of a string of moves from the start; nothing where a move is not open or may not follow the one before it.
  std::optional<std::vector<Edge>> edges(std::span<const std::uint32_t> actions) const;

  /// Judges a string of edges from the start, as many as a walk is long, and the last leg. Infinite score where that
  /// may not join the goal.
  LatticeFlight judge(std::span<const Edge> edges) const;

  /// Cost of a route; nothing unless the moves are one.
  std::optional<FlownActions> fly(std::span<const std::uint32_t> actions) const;

  /// Nodes of such a string from the start on, and the goal.
  std::vector<Vec3> places(std::span<const std::uint32_t> actions) const;

 private:
  /// A leg after another one (none: null).
  void count_leg(const Vec3* before, const Vec3& leg, LatticeFaults& faults) const;
  void count_faults(std::span<const Edge> edges, LatticeFlight& flight) const;
  void join(Node node, unsigned came, LatticeFlight& flight) const;

  LatticeFrame frame_;
  LatticeMoves moves_;
  LatticeScore score_;
  double range_m_;
};

}  // namespace alate
