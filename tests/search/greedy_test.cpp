#include "search/greedy.hpp"

#include <gtest/gtest.h>

#include "string_space.hpp"

namespace alate {
namespace {

using test::LineSpace;

SearchResult walk(const LineSpace& space, GreedyOptions options = {}) {
  Executor executor;
  RunContext run(executor, {});
  return Greedy(space, options).run(run);
}

TEST(Greedy, TakesTheCheapestStepAndNotTheCheapestWay) {
  const SearchResult result = walk({.costs = {{9, 1, 2, 3, 9}, {9, 50, 50, 1, 9}}});
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.actions, (std::vector<std::size_t>{0, 0})) << "ties go to the first action";
  EXPECT_EQ(result.cost, 10);
  EXPECT_EQ(result.expansions, 2U);
  EXPECT_EQ(result.candidates, 6U);
}

TEST(Greedy, StepsBackWhereNothingCanBeFlown) {
  // After the cheap step to the left there are only walls.
  const LineSpace space{.costs = {{9, 1, 5, 6, 9}, {-1, -1, -1, 1, 1}, {-1, -1, 2, 2, 2}}};
  const SearchResult result = walk(space);
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.cost, 5 + 1 + 2);
  EXPECT_FALSE(walk(space, {.max_step_backs = 0}).found);
}

TEST(Greedy, EndsWithNothingWhereThereIsNoWay) {
  const SearchResult result = walk({.costs = {{1, 1, 1}, {-1, -1, -1}}});
  EXPECT_FALSE(result.found);
  EXPECT_EQ(result.expansions, 4U) << "the start and its three dead ends";
}

}  // namespace
}  // namespace alate
