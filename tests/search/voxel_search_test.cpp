// Exact searches on voxels against Dijkstra's algorithm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "data/scen_file.hpp"
#include "search/voxel/voxel_astar.hpp"
#include "search/voxel/voxel_jps.hpp"
#include "support/shared_data.hpp"
#include "support/voxel_sites.hpp"

namespace alate {
namespace {

template <class Search>
struct VoxelSearch : testing::Test {
  VoxelWay find(Search& search, const VoxelCell& start, const VoxelCell& goal) {
    RunContext run(executor, {});
    return search.find(VoxelBits::place(start), VoxelBits::place(goal), run);
  }
  Executor executor{1};
};
using Searches = testing::Types<VoxelAStar, VoxelJps>;
TYPED_TEST_SUITE(VoxelSearch, Searches);

int sign(int value) { return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0); }

/// Follows the way cell by cell; its length, or nothing if a step is not free.
std::optional<VoxelLength> walked(const VoxelGrid& voxels, const std::vector<VoxelPlace>& corners) {
  VoxelLength length;
  VoxelCell at = VoxelBits::cell_of(corners.front());
  for (const VoxelPlace place : corners) {
    const VoxelCell corner = VoxelBits::cell_of(place);
    while (at != corner) {
      const VoxelCell step{sign(corner[0] - at[0]), sign(corner[1] - at[1]), sign(corner[2] - at[2])};
      if (!test::is_free_step(voxels, at, step)) return std::nullopt;
      for (std::size_t axis = 0; axis < 3; ++axis) at.at(axis) += step.at(axis);
      const int axes = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
      ++(axes == 1 ? length.straights : axes == 2 ? length.diagonals : length.triples);
    }
  }
  return length;
}

/// Sides of all kinds: some longer than a word of bits, some of one cell.
VoxelCell random_size(int map, std::mt19937_64& random) {
  const auto below = [&](unsigned most) { return 1 + static_cast<int>(random() % most); };
  VoxelCell size{below(9), below(9), below(9)};
  if (map % 4 == 0) size.at(random() % 3) = below(140);
  return size;
}

VoxelCell random_cell(const VoxelGrid& voxels, std::mt19937_64& random) {
  VoxelCell cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell.at(axis) = static_cast<int>(random() % static_cast<unsigned>(voxels.size().at(axis)));
  return cell;
}

/// Several queries on each map, so that what one leaves behind would show in the next.
TYPED_TEST(VoxelSearch, IsAsShortAsDijkstras) {
  std::mt19937_64 random(7);
  int without = 0;
  for (int map = 0; map < 400; ++map) {
    VoxelGrid voxels = test::drawn_voxels(random_size(map, random), static_cast<unsigned>(random() % 50), random);
    std::array<VoxelCell, 5> ends{};
    for (VoxelCell& end : ends) voxels.free(end = random_cell(voxels, random));
    const VoxelBits bits(voxels);
    TypeParam search(bits);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double least = test::shortest_length(voxels, ends.at(i), ends.at(i + 1));
      const VoxelWay way = this->find(search, ends.at(i), ends.at(i + 1));
      ASSERT_TRUE(way.finished);
      ASSERT_EQ(way.found, std::isfinite(least)) << map;
      without += way.found ? 0 : 1;
      if (!way.found) continue;
      ASSERT_NEAR(way.length.value(), least, 1e-9) << map;
      EXPECT_EQ(way.corners.front(), VoxelBits::place(ends.at(i)));
      EXPECT_EQ(way.corners.back(), VoxelBits::place(ends.at(i + 1)));
      const auto length = walked(voxels, way.corners);
      ASSERT_TRUE(length.has_value()) << map;
      EXPECT_EQ(*length, way.length);
    }
  }
  EXPECT_GT(without, 100);
}

TYPED_TEST(VoxelSearch, NoEdgeOrCornerIsCut) {
  VoxelGrid voxels({2, 2, 2});
  voxels.block({1, 0, 0});
  const VoxelBits bits(voxels);
  TypeParam search(bits);
  EXPECT_EQ(this->find(search, {0, 0, 0}, {1, 1, 0}).length, (VoxelLength{2, 0, 0}));
  EXPECT_EQ(this->find(search, {0, 0, 0}, {1, 1, 1}).length, (VoxelLength{1, 1, 0}));
  EXPECT_EQ(this->find(search, {0, 0, 0}, {0, 1, 1}).length, (VoxelLength{0, 1, 0}));
}

TYPED_TEST(VoxelSearch, CornersAreWhereTheDirectionChanges) {
  const VoxelGrid voxels({9, 7, 5});
  const VoxelBits bits(voxels);
  TypeParam search(bits);
  const VoxelWay way = this->find(search, {0, 0, 0}, {8, 6, 4});
  EXPECT_EQ(way.length, (VoxelLength{2, 2, 4}));
  EXPECT_EQ(this->find(search, {1, 1, 1}, {1, 6, 1}).corners.size(), 2U);
  EXPECT_EQ(this->find(search, {1, 1, 1}, {1, 1, 1}).corners.size(), 1U);
}

TYPED_TEST(VoxelSearch, AStoppedSearchProvesNothing) {
  const VoxelGrid voxels({9, 7, 5});
  const VoxelBits bits(voxels);
  TypeParam search(bits);
  std::stop_source source;
  source.request_stop();
  RunContext run(this->executor, {.stop = source.get_token()});
  const VoxelWay way = search.find(VoxelBits::place({0, 0, 0}), VoxelBits::place({8, 6, 4}), run);
  EXPECT_FALSE(way.found);
  EXPECT_FALSE(way.finished);
}

/// A share of the rows of two maps; fewer for A*, which takes longer.
TYPED_TEST(VoxelSearch, ReachesThePublishedOptima) {
  ALATE_NEEDS_SHARED_DATA("movingai/3d");
  constexpr std::size_t kEvery = std::is_same_v<TypeParam, VoxelJps> ? 20 : 200;
  std::size_t rows = 0;
  for (const std::string name : {"Simple", "Complex"}) {
    std::vector<Fault> faults;
    const auto scen = read_voxel_scen_file(test::shared_data("movingai/3d/" + name + ".3dmap.3dscen").string(), faults);
    ASSERT_TRUE(scen.has_value()) << to_string(faults.front());
    const VoxelBits bits(scen->voxels);
    TypeParam search(bits);
    for (std::size_t i = 0; i < scen->rows.size(); i += kEvery) {
      const VoxelScenRow& row = scen->rows[i];
      const VoxelWay way = this->find(search, row.start, row.goal);
      EXPECT_NEAR(way.length.value(), row.optimum, scen_tolerance(row.optimum)) << name << " row " << i;
      ++rows;
    }
  }
  EXPECT_EQ(rows, std::size_t{20'000} / kEvery);
}

TEST(VoxelMoves, WithoutWallsOnlyTheNaturalSuccessorsAreLeft) {
  const VoxelMoves& moves = VoxelMoves::table();
  for (unsigned came = 0; came < kVoxelDirections; ++came) {
    if (came == kNoVoxelDirection) continue;
    VoxelMoves::Set parts = 0;  // itself, and what it is made of
    for (unsigned d = 0; d < kVoxelDirections; ++d) {
      bool within = d != kNoVoxelDirection;
      for (std::size_t axis = 0; axis < 3; ++axis)
        within = within &&
                 (kVoxelShifts.at(d).at(axis) == 0 || kVoxelShifts.at(d).at(axis) == kVoxelShifts.at(came).at(axis));
      if (within) parts |= VoxelMoves::Set{1} << d;
    }
    EXPECT_EQ(moves.natural(came), parts) << came;
  }
}

TEST(VoxelBits, RunsStopWhereAWallBesideEnds) {
  VoxelGrid voxels({200, 3, 3});
  voxels.block({99, 2, 2});
  voxels.block({150, 1, 1});
  const VoxelBits bits(voxels);
  constexpr unsigned kEast = voxel_direction({1, 0, 0});
  constexpr unsigned kWest = voxel_direction({-1, 0, 0});
  const auto run = [&](const VoxelCell& from, unsigned direction) {
    const VoxelBits::Run found = bits.run(VoxelBits::place(from), direction);
    return std::pair(found.steps, found.turns);
  };
  EXPECT_EQ(run({3, 1, 1}, kEast), std::pair(97U, true));  // to 100, where the wall has ended
  EXPECT_EQ(run({100, 1, 1}, kEast), std::pair(50U, false));
  EXPECT_EQ(run({149, 1, 1}, kWest), std::pair(51U, true));  // to 98
  EXPECT_EQ(run({98, 1, 1}, kWest), std::pair(99U, false));  // the side of the map
  EXPECT_EQ(run({3, 0, 0}, kEast), std::pair(148U, true));   // beside the second wall alone
  EXPECT_TRUE(bits.is_beside_wall(VoxelBits::place({98, 1, 1})));
  EXPECT_FALSE(bits.is_beside_wall(VoxelBits::place({97, 1, 1})));
}

/// No whole numbers up to 97 000 but zeros make a way of no cost. Those that do form a lattice at right angles to the
/// costs. These two are a base of it, as their cross product is the costs, which have no common divisor; and as it is
/// reduced (Gauss), none of the lattice is shorter than the first.
TEST(VoxelCost, TakesNoTwoLengthsForEqual) {
  using Numbers = std::array<std::int64_t, 3>;
  constexpr Numbers kFirst{-153'704, 56'075, 42'956};
  constexpr Numbers kSecond{-87'285, -98'783, 131'050};
  constexpr Numbers kCosts{kVoxelStraight, kVoxelDiagonal, kVoxelTriple};
  const auto dot = [](const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    EXPECT_EQ(kFirst.at(j) * kSecond.at(k) - kFirst.at(k) * kSecond.at(j), kCosts.at(i));
  }
  EXPECT_EQ(std::gcd(std::gcd(kCosts[0], kCosts[1]), kCosts[2]), 1);
  EXPECT_LE(2 * std::abs(dot(kFirst, kSecond)), dot(kFirst, kFirst));
  EXPECT_LE(dot(kFirst, kFirst), dot(kSecond, kSecond));
  EXPECT_GT(dot(kFirst, kFirst), std::int64_t{3} * 97'000 * 97'000);
  const auto off = [](VoxelCost cost, long double root) {
    return std::abs(static_cast<long double>(cost) - root * static_cast<long double>(kVoxelStraight));
  };
  EXPECT_LT(97'000 * (off(kVoxelDiagonal, std::sqrt(2.0L)) + off(kVoxelTriple, std::sqrt(3.0L))), 1);
}

}  // namespace
}  // namespace alate
