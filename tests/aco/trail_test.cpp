// Trails: lazy evaporation against doing it at once, bounds, stores.
#include "aco/pheromone/trail.hpp"

#include <gtest/gtest.h>

#include <map>

#include "aco/pheromone/grid_cells.hpp"
#include "aco/pheromone/hash_cells.hpp"
#include "alate/core/stream.hpp"

namespace alate {
namespace {

TEST(Trail, LazyEvaporationIsThatOfEveryCellAtEveryIteration) {
  Trail<HashCells> trail(HashCells(1), {.evaporation = 0.8});
  std::map<TrailKey, double> plain;
  Stream stream(1, 0, 0);
  for (int iteration = 0; iteration < 300; ++iteration) {
    for (int i = 0; i < 5; ++i) {
      const TrailKey key = 1 + stream.below(40);
      trail.join(key);
      plain.try_emplace(key, 1.0);  // unknown places have 1
    }
    trail.evaporate();
    for (auto& [key, level] : plain) level *= 1 - 0.8;
    const TrailKey key = 1 + stream.below(40);
    const double amount = stream.uniform();
    trail.add(key, amount);
    plain.try_emplace(key, 1.0).first->second += amount;
    for (const auto& [known, level] : plain)
      ASSERT_NEAR(static_cast<double>(trail.level(known)), level, 1e-5 * level + 1e-12) << iteration;
  }
}

TEST(Trail, UnknownPlacesStayAtOneOrDecayWithTheRest) {
  Trail<HashCells> published(HashCells(1), {.evaporation = 0.8});
  Trail<HashCells> max_min(HashCells(1), {.evaporation = 0.2, .unknown_decays = true});
  published.evaporate();
  max_min.evaporate();
  EXPECT_FLOAT_EQ(published.level(7), 1);
  EXPECT_FLOAT_EQ(max_min.level(7), 0.8F);
  max_min.levels().set_bounds(2, 40);
  EXPECT_FLOAT_EQ(max_min.level(7), 2);
  max_min.add(7, 1000);
  EXPECT_FLOAT_EQ(max_min.level(7), 40);
  EXPECT_TRUE(max_min.known(7));
}

TEST(Trail, EverythingEvaporatesAtRhoOneButStaysKnown) {
  Trail<HashCells> trail(HashCells(1), {.evaporation = 1});
  trail.join(5);
  trail.evaporate();
  EXPECT_TRUE(trail.known(5));
  EXPECT_NEAR(trail.level(5), 0, 1e-30);
  trail.add(5, 3);
  EXPECT_FLOAT_EQ(trail.level(5), 3);
}

TEST(Trail, BlendMovesTowardsTheTarget) {
  Trail<HashCells> trail(HashCells(1), {.evaporation = 0});
  trail.blend(4, 0.25, 5);
  EXPECT_FLOAT_EQ(trail.level(4), 0.75F * 1 + 0.25F * 5);
}

/// Makes every third place known, each with a level of its own.
template <class Store>
void expect_levels_of_choices_to_be_those_of_places(Store store) {
  Choices choices;
  choices.resize(125);
  Stream stream(3, 1, 4);
  for (std::size_t k = 0; k < choices.trail.size(); ++k) {
    choices.x[k] = static_cast<float>(60 * stream.uniform() - 30);
    choices.y[k] = static_cast<float>(60 * stream.uniform() - 30);
    choices.z[k] = static_cast<float>(60 * stream.uniform() - 30);
    if (k % 3 == 0) store.at(store.name(choices.x[k], choices.y[k], choices.z[k])) = static_cast<float>(k + 1);
  }
  store.find_all(choices);
  for (std::size_t k = 0; k < choices.trail.size(); ++k) {
    const TrailKey key = store.name(choices.x[k], choices.y[k], choices.z[k]);
    EXPECT_EQ(choices.trail[k], store.find(key)) << k;
    EXPECT_TRUE(k % 3 != 0 || store.find(key) != 0) << k;
  }
}

TEST(TrailStores, FindTheLevelsOfChoicesAsThoseOfPlaces) {
  expect_levels_of_choices_to_be_those_of_places(HashCells(1e-4));
  auto grid = GridCells::over({.min = {-20, -20, -20}, .max = {20, 20, 20}}, 0.5F);
  ASSERT_TRUE(grid);
  expect_levels_of_choices_to_be_those_of_places(*std::move(grid));  // a third of the places lie outside
}

TEST(TrailStores, PointsAreTheSameToATenthOfAMillimetre) {
  const HashCells points(1e-4);
  EXPECT_EQ(points.name(1.00001F, 2, 3), points.name(1.00002F, 2, 3));
  EXPECT_NE(points.name(1.0000F, 2, 3), points.name(1.0002F, 2, 3));
}

TEST(TrailStores, AGridThatWouldBeTooLargeIsNotMade) {
  EXPECT_FALSE(GridCells::over({.min = {0, 0, 0}, .max = {1e4F, 1e4F, 1e4F}}, 1));
}

}  // namespace
}  // namespace alate
