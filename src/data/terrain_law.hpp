// Made-up ground, drawn by a law: worlds to fly in where no data are at hand.
#pragma once

#include <cstdint>
#include <vector>

#include "alate/core/geometry.hpp"

namespace alate {

enum class TerrainLaw { canyon, hills };

inline constexpr double kDrawnCell_m = 10;

/// Square ground: its south-west post lies at (0, 0), and posts are kDrawnCell_m apart.
struct DrawnTerrain {
  int side = 0;              ///< Posts along a side.
  std::vector<float> posts;  ///< Row-major from the north-west; whole metres.
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();  ///< Both are places of posts.

  double width_m() const { return kDrawnCell_m * (side - 1); }
  float& post(int column, int row) {
    return posts[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column)];
  }
  Vec2 place(int column, int row) const { return kDrawnCell_m * Vec2(column, side - 1 - row); }
  /// Of the post at `place`.
  double height(const Vec2& place) const;
};

/// `side` posts along a side, 100 or more. canyon: a canyon winds from the west side to the east side
/// through a high plain; at every bend a dead end runs straight on. hills: noise of wavelengths from 1200 m down to
/// 150 m, from the lowest post in the south-west to that in the north-east. The same law, side and seed give the same
/// heights on every machine: nothing but sums, products and square roots goes into them.
DrawnTerrain draw_terrain(TerrainLaw law, int side, std::uint64_t seed);

}  // namespace alate
