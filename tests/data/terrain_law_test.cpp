// Drawn ground: what the laws promise.
#include "data/terrain_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "alate/data/height_raster.hpp"

namespace alate {
namespace {

/// The worlds that are kept are what the law draws, to the last bit.
void expect_kept(const char* file, const DrawnTerrain& drawn) {
  std::vector<Fault> faults;
  const auto kept =
      read_height_raster(std::string(ALATE_SOURCE_DIR "/examples/worlds/") + file, Frame::local(), faults);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->columns, drawn.side);
  EXPECT_EQ(kept->rows, drawn.side);
  EXPECT_EQ(kept->posts, drawn.posts);
  EXPECT_EQ(kept->height({0, 0}), drawn.height({0, 0}));
  EXPECT_EQ(kept->height(drawn.start), drawn.height(drawn.start));
}

TEST(TerrainLaw, TheCanyonIsThatOfTheExample) { expect_kept("canyon.tif", draw_terrain(TerrainLaw::canyon, 601, 1)); }

TEST(TerrainLaw, TheHillsAreThoseOfTheExample) {
  expect_kept("lowceiling.tif", draw_terrain(TerrainLaw::hills, 401, 8));
}

TEST(TerrainLaw, AnotherSeedDrawsOtherGround) {
  for (const TerrainLaw law : {TerrainLaw::canyon, TerrainLaw::hills})
    EXPECT_NE(draw_terrain(law, 150, 1).posts, draw_terrain(law, 150, 2).posts);
}

/// From side to side below the plain, which lies higher than anything else.
TEST(TerrainLaw, TheCanyonGoesThroughThePlain) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    DrawnTerrain terrain = draw_terrain(TerrainLaw::canyon, 301, seed);
    EXPECT_EQ(std::ranges::max(terrain.posts), 800);
    for (int column = 0; column < terrain.side; ++column) {
      float lowest = 800;
      for (int row = 0; row < terrain.side; ++row) lowest = std::min(lowest, terrain.post(column, row));
      EXPECT_LT(lowest, 540) << column;
      EXPECT_GT(lowest, 450) << column;
    }
  }
}

TEST(TerrainLaw, EndsLieLowAndFarApart) {
  const DrawnTerrain hills = draw_terrain(TerrainLaw::hills, 301, 5);
  EXPECT_LT(hills.start.norm(), hills.goal.norm());
  EXPECT_GT((hills.goal - hills.start).norm(), hills.width_m());
  const Vec2 inward(300, 300);
  EXPECT_LT(hills.height(hills.start), hills.height(inward));
  EXPECT_LT(hills.height(hills.goal), hills.height(Vec2::Constant(hills.width_m()) - inward));
}

}  // namespace
}  // namespace alate
