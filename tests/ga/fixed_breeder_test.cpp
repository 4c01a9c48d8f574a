// The published genetic algorithm, piece by piece.
#include "ga/fixed_breeder.hpp"

#include <gtest/gtest.h>

#include <set>

#include "data/correction_law.hpp"
#include "search/sparse_astar.hpp"

namespace alate {
namespace {

TEST(AdaptiveRate, IsGreatestBelowTheMeanAndLeastForTheBest) {
  const AdaptiveRate rate{.high = 0.9, .low = 0.6};
  const FitnessStats stats{.mean = 2, .most = 4};
  EXPECT_EQ(rate(1.9, stats), 0.9);
  EXPECT_EQ(rate(2, stats), 0.9);
  EXPECT_NEAR(rate(3, stats), 0.75, 1e-15);
  EXPECT_NEAR(rate(4, stats), 0.6, 1e-15);
  EXPECT_EQ(rate(2, {.mean = 2, .most = 2}), 0.9);
  EXPECT_EQ((AdaptiveRate{.high = 0.9, .low = 0.9}(4, stats)), 0.9);
}

class Chromosomes : public testing::Test {
 protected:
  Chromosomes() { cost_.goal = {.per_m = 1}; }

  FixedBreeder breeder(FixedBreederOptions options = {}) const {
    options.crossover = {.high = 0.9, .low = 0.6};
    options.mutation = {.high = 0.2, .low = 0.01};
    return {graph_, rectangle_, cost_, options};
  }

  CorrectionField field_ = draw_corrections(CorrectionLaw::set1, 200, 3);
  CorrectionGraph graph_{field_.navigation, field_.start, field_.goal};
  double direct_m_ = graph_.length(graph_.start(), graph_.goal());
  GeneRectangle rectangle_{graph_, 0.2 * direct_m_, 10};
  SampledCost cost_;
  Executor executor_{1};
  RunContext run_{executor_, {}};
};

TEST_F(Chromosomes, RectangleHoldsThePointsNearTheLine) {
  std::size_t inside = 0;
  const Vec2 start = field_.start.head<2>();
  const Vec2 along = (field_.goal.head<2>() - start).normalized();
  for (const CorrectionPoint& point : field_.navigation.points) {
    const Vec2 from_start = point.position.head<2>() - start;
    const double s = from_start.dot(along);
    inside += s >= 0 && s <= direct_m_ && (from_start - s * along).norm() <= 0.1 * direct_m_ ? 1U : 0U;
  }
  EXPECT_EQ(rectangle_.points(), inside);
  EXPECT_GT(inside, 20U);
}

TEST_F(Chromosomes, ACoordinateBecomesTheNearestUnusedPointOfItsCell) {
  Stream stream(1, 0, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const auto place = rectangle_.draw(stream);
    ASSERT_TRUE(rectangle_.contains(place));
    const std::size_t cell = rectangle_.cell_of(place);
    EXPECT_LT(cell, 10U);
    const auto distance = [&](CorrectionGraph::Node i) {
      const auto at = rectangle_.at(i);
      return std::hypot(at.along_m - place.along_m, at.left_m - place.left_m);
    };
    const auto nearest = rectangle_.nearest_unused(place, {});
    const auto second = rectangle_.nearest_unused(place, {nearest});
    EXPECT_NE(nearest, second);
    EXPECT_EQ(rectangle_.cell_of(rectangle_.at(nearest)), cell);
    EXPECT_TRUE(distance(nearest) <= distance(second) || rectangle_.cell_of(rectangle_.at(second)) != cell);
    for (CorrectionGraph::Node i = 0; i < graph_.point_count(); ++i) {
      const auto at = rectangle_.at(i);
      if (!rectangle_.contains(at) || rectangle_.cell_of(at) != cell) continue;
      EXPECT_GE(distance(i), distance(nearest));
    }
  }
}

TEST_F(Chromosomes, BeginInsideTheRectangleInOrderAndNeverRepeatAPoint) {
  const FixedBreeder breeder = this->breeder({.genes = 13});
  Population population;
  for (std::uint64_t a = 0; a < 60; ++a) {
    Stream stream(5, 1, a);
    population.push_back(breeder.first(stream, run_));
    for (const auto gene : population.back().genes) EXPECT_TRUE(rectangle_.contains(rectangle_.at(gene)));
  }
  for (std::uint64_t generation = 2; generation < 12; ++generation) {
    Population born;
    for (std::size_t a = 0; a < population.size(); ++a) {
      Stream stream(5, generation, a);
      born.push_back(breeder.child(population, a, stream, run_));
    }
    for (const Individual& one : born) {
      EXPECT_EQ(one.genes.size(), 13U);
      EXPECT_EQ(std::set(one.genes.begin(), one.genes.end()).size(), 13U);
      EXPECT_GE(one.cost, fly(graph_, one.genes).length_m);
    }
    EXPECT_EQ(born[0].cost, std::ranges::min_element(population, {}, &Individual::cost)->cost);
    FixedBreeder::survive(population, born);
  }
}

TEST_F(Chromosomes, NoMoreGenesThanPoints) {
  const FixedBreeder breeder = this->breeder({.genes = 5000});
  Stream stream(1, 1, 1);
  EXPECT_EQ(breeder.first(stream, run_).genes.size(), rectangle_.points());
}

TEST_F(Chromosomes, CostIsTheLengthExactlyWhereNoLimitIsBroken) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CorrectionField field = draw_corrections(CorrectionLaw::set1, 500, seed);
    const CorrectionGraph graph(field.navigation, field.start, field.goal);
    const SparseAstarResult route = sparse_astar(graph, {}, run_);
    ASSERT_TRUE(route.found);
    const Trip trip = fly(graph, route.points);
    EXPECT_EQ(cost_(graph, trip), trip.length_m);
    PointString broken = route.points;
    while (!broken.empty() && fly(graph, broken).keeps_limits) broken.pop_back();
    const Trip too_far = fly(graph, broken);
    ASSERT_FALSE(too_far.keeps_limits);
    EXPECT_GT(cost_(graph, too_far), too_far.length_m);
  }
}

TEST_F(Chromosomes, CostCountsHeightAboveTheCeilingAndLengthBeyondTheRange) {
  cost_.metres_a_unit = 0;
  const Trip trip = fly(graph_, {});
  EXPECT_EQ(cost_(graph_, trip), direct_m_);
  cost_.ceiling_m = field_.start.z() - 7;
  EXPECT_NEAR(cost_(graph_, trip), direct_m_ + 7, 1e-6);
  cost_.over_altitude = 3;
  EXPECT_NEAR(cost_(graph_, trip), direct_m_ + 21, 1e-6);
  cost_.range_m = direct_m_ - 1000;
  EXPECT_NEAR(cost_(graph_, trip), direct_m_ + 1021, 1e-6);
}

TEST_F(Chromosomes, CostSamplesTheErrorsOfALeg) {
  cost_.with_goal = false;
  cost_.only_excess = false;
  const Trip trip = fly(graph_, {});
  // Both errors grow from 0 to e: the mean of k e / 10, k = 1 to 10, is 0.55 e.
  EXPECT_NEAR(cost_(graph_, trip), 0.55 * 0.001 * direct_m_, 1e-9);
  cost_.samples = 1;
  EXPECT_NEAR(cost_(graph_, trip), 0.001 * direct_m_, 1e-9);
  cost_.only_excess = true;
  EXPECT_NEAR(cost_(graph_, trip), 0.001 * direct_m_ - 30, 1e-9);
}

}  // namespace
}  // namespace alate
