#include "search/string_windows.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "data/correction_law.hpp"
#include "search/label_setting/shortest.hpp"
#include "search/sparse_astar.hpp"

namespace alate {
namespace {

/// A graph with all that windows need, and a first route that is not the shortest.
struct Case {
  Case(CorrectionLaw law, int points, std::uint64_t seed, RunContext& run)
      : field(draw_corrections(law, points, seed)),
        graph(field.navigation, field.start, field.goal),
        to_go(graph, RelaxedToGo::Extent::everywhere, run),
        successors(graph, to_go, 1000, run),
        first(sparse_astar(graph, {}, run)) {}

  PointString improved(const WindowOptions& options, const RoutePrice& price, RunContext& run) const {
    PointString points = first.points;
    const bool changed = StringWindows(graph, successors, price, options).improve(points, run);
    EXPECT_EQ(changed, points != first.points);
    return points;
  }

  CorrectionField field;
  CorrectionGraph graph;
  RelaxedToGo to_go;
  Successors successors;
  SparseAstarResult first;
};

class StringWindowsTest : public testing::Test {
 protected:
  Executor executor_{1};
  RunContext run_{executor_, {}};
};

TEST_F(StringWindowsTest, ChangesKeepLimitsAndNeverMakeItDearer) {
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Case one(seed % 2 == 0 ? CorrectionLaw::set1 : CorrectionLaw::set2, 300, seed, run_);
    if (!one.first.found) continue;
    const Trip before = fly(one.graph, one.first.points);
    const Trip after = fly(one.graph, one.improved({}, {}, run_));
    EXPECT_TRUE(after.keeps_limits);
    EXPECT_LE(after.length_m, before.length_m);
    better += after.length_m < before.length_m ? 1 : 0;
  }
  EXPECT_GT(better, 20);
}

TEST_F(StringWindowsTest, AWindowOverAShortRouteFindsTheShortest) {
  int judged = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Case one(CorrectionLaw::set1, 25, seed, run_);
    const auto best = shortest_route(one.graph, {}, run_).route;
    if (!best || best->points.size() > 3 || one.first.points.size() > 10) continue;
    ++judged;
    const Trip after = fly(one.graph, one.improved({.most_old = 10, .most_new = 3}, {}, run_));
    EXPECT_NEAR(after.length_m, best->length_m, 1e-6) << seed;
  }
  EXPECT_GT(judged, 5);
}

/// A string that comes back to its points, as crossing two may: no window may leave a point beside itself.
TEST_F(StringWindowsTest, ALoopIsLeftOutWhole) {
  int loops = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Case one(CorrectionLaw::set2, 300, seed, run_);
    if (!one.first.found || one.first.points.size() < 3) continue;
    for (std::size_t i = 0; i + 1 < one.first.points.size(); ++i) {
      PointString looped = one.first.points;
      looped.insert(looped.begin() + static_cast<std::ptrdiff_t>(i) + 2, one.first.points[i]);  // a b a
      const bool already = std::ranges::adjacent_find(looped) != looped.end();
      if (already || !fly(one.graph, looped).keeps_limits) continue;
      ++loops;
      StringWindows(one.graph, one.successors, {}, {.most_old = 1}).improve(looped, run_);
      EXPECT_EQ(std::ranges::adjacent_find(looped), looped.end()) << seed << " " << i;
    }
  }
  EXPECT_GT(loops, 5);
}

TEST_F(StringWindowsTest, DearCorrectionsAreLeftOut) {
  int fewer = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Case one(CorrectionLaw::set1, 400, seed, run_);
    if (!one.first.found) continue;
    const PointString short_one = one.improved({}, {}, run_);
    const PointString few = one.improved({}, {.per_m = 1, .per_correction = 1e6}, run_);
    EXPECT_LE(few.size(), one.first.points.size());
    EXPECT_TRUE(fly(one.graph, few).keeps_limits);
    fewer += few.size() < short_one.size() ? 1 : 0;
  }
  EXPECT_GT(fewer, 2);
}

}  // namespace
}  // namespace alate
