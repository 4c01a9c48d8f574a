// The best string of moves within a corridor of a cell about a route on a terrain lattice, again and again until it is
// the route itself.
//
// Dynamic programming over pairs of corridor nodes in a row, so turns count and turn limits hold: exact in a
// neighbourhood of 9^planes strings, blind beyond it. Source: alate; very large-scale neighbourhoods: Ahuja, Ergun,
// Orlin, Punnen 2002. Cost: 729 steps a plane and round.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/terrain_lattice.hpp"

namespace alate {

class Corridor {
 public:
  /// Better moves in place of those of a route; were they changed?
  bool operator()(const TerrainLattice& lattice, std::vector<std::uint32_t>& actions, RunContext& run);

 private:
  static constexpr std::size_t kWide = 9;
  using Node = TerrainLattice::Node;

  /// Nodes of a plane within a cell of the route, and ways to them.
  struct Gate {
    std::array<Node, kWide> node{};
    std::array<bool, kWide> exists{};
    /// By node and the one before it: cost, the move that leads here, and the node before that one.
    std::array<std::array<double, kWide>, kWide> cost{};
    std::array<std::array<std::uint8_t, kWide>, kWide> came{};
    std::array<std::array<std::uint8_t, kWide>, kWide> back{};
  };

  void lay(const TerrainLattice& lattice, std::span<const std::uint32_t> actions);
  void pass(const TerrainLattice& lattice, std::size_t gate);
  void arrive(const TerrainLattice& lattice, std::size_t gate, std::array<std::size_t, 3> through);
  bool trace(const TerrainLattice& lattice, std::vector<std::uint32_t>& actions) const;

  std::vector<Gate> gates_;
};

}  // namespace alate
