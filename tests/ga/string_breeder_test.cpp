// Strings of any length: growing, repairing, breeding.
#include "ga/string_breeder.hpp"

#include <gtest/gtest.h>

#include "data/correction_law.hpp"

namespace alate {
namespace {

struct Nursery {
  Nursery(CorrectionField drawn, RunContext& run)
      : field(std::move(drawn)),
        graph(field.navigation, field.start, field.goal),
        to_go(graph, RelaxedToGo::Extent::everywhere, run),
        successors(graph, to_go, 128, run),
        windows(graph, successors, {}, {}),
        breeder(graph, to_go, successors, windows, {}, {}) {}

  CorrectionField field;
  CorrectionGraph graph;
  RelaxedToGo to_go;
  Successors successors;
  StringWindows windows;
  StringBreeder breeder;
};

class Strings : public testing::Test {
 protected:
  Executor executor_{1};
  RunContext run_{executor_, {}};
};

TEST_F(Strings, AllThatIsBornKeepsTheLimits) {
  int born = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Nursery nursery(draw_corrections(seed % 2 == 0 ? CorrectionLaw::set1 : CorrectionLaw::set2, 250, seed), run_);
    Population population;
    for (std::uint64_t a = 0; a < 20; ++a) {
      Stream stream(seed, 1, a);
      population.push_back(nursery.breeder.first(stream, run_));
    }
    for (std::uint64_t a = 0; a < 60; ++a) {
      Stream stream(seed, 2, a);
      population.push_back(nursery.breeder.child(population, a, stream, run_));
    }
    for (const Individual& one : population) {
      if (!one.feasible()) continue;
      ++born;
      const Trip trip = fly(nursery.graph, one.genes);
      EXPECT_TRUE(trip.keeps_limits);
      EXPECT_EQ(trip.length_m, one.price);
    }
  }
  EXPECT_GT(born, 500);
}

TEST_F(Strings, ARepairKeepsTheHeadDrawsFreshPointsAndJoinsTheTail) {
  const Nursery nursery(draw_corrections(CorrectionLaw::set1, 611, 3), run_);
  Stream first(1, 1, 1);
  const Individual parent = nursery.breeder.first(first, run_);
  ASSERT_TRUE(parent.feasible());
  const Trip trip = fly(nursery.graph, parent.genes);
  int grown = 0;
  for (std::uint64_t a = 0; a < 200; ++a) {
    Stream stream(2, 1, a);
    const std::size_t kept = stream.below(parent.genes.size() + 1);
    const auto child =
        nursery.breeder.grow({.head = trip, .kept = kept, .tail = trip, .from = kept + 1, .fresh = 1}, stream, run_);
    if (!child) continue;
    ++grown;
    EXPECT_GT(child->size(), kept);
    EXPECT_TRUE(std::equal(child->begin(), child->begin() + static_cast<std::ptrdiff_t>(kept), parent.genes.begin()));
    EXPECT_TRUE(fly(nursery.graph, *child).keeps_limits);
  }
  EXPECT_GT(grown, 150);
}

TEST(Survival, TheCheapestLiveOnEachRouteOnce) {
  const auto one = [](double cost, CorrectionGraph::Node gene) {
    return Individual{.genes = {gene}, .cost = cost, .price = cost};
  };
  Population population{one(5, 1), one(3, 2), {}};
  Population born{one(3, 2), one(3, 4), one(4, 5)};
  StringBreeder::survive(population, born);
  ASSERT_EQ(population.size(), 3U);
  EXPECT_EQ(population[0].genes, PointString{2});
  EXPECT_EQ(population[1].genes, PointString{4});
  EXPECT_EQ(population[2].genes, PointString{5});
}

TEST_F(Strings, WithoutAWayNothingIsBorn) {
  CorrectionField field = draw_corrections(CorrectionLaw::set1, 100, 1);
  field.goal.x() += 40'000;
  const Nursery nursery(field, run_);
  Stream stream(1, 1, 1);
  EXPECT_FALSE(nursery.breeder.first(stream, run_).feasible());
}

}  // namespace
}  // namespace alate
