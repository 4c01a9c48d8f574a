#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "alate/core/stream.hpp"
#include "data/correction_law.hpp"
#include "search/turning/turning_front.hpp"

namespace alate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Field {
  Navigation navigation;
  Vec3 start = Vec3::Zero();
  Vec3 goal{18000, 0, 0};
};

/// A few points on the way, with limits that take two to five of them.
Field small_field(std::uint64_t seed) {
  Stream random(seed, 1, 1);
  Field field;
  Navigation& navigation = field.navigation;
  navigation.drift_vertical = 0.001;
  navigation.drift_horizontal = 0.0012;
  navigation.at_vertical = {.vertical = 12, .horizontal = 11};
  navigation.at_horizontal = {.vertical = 11, .horizontal = 13};
  navigation.theta = 13;
  navigation.turn_model = TurnModel::arc_tangent;
  navigation.turn_radius_m = 900;
  for (int id = 0; id < 9; ++id)
    navigation.points.push_back(
        {.id = id,
         .position = {18000 * random.uniform(), 9000 * (random.uniform() - 0.5), 3000 * (random.uniform() - 0.5)},
         .kind = id % 2 == 0 ? PointKind::vertical : PointKind::horizontal});
  return field;
}

CorrectionGraph graph_of(const Field& field) { return {field.navigation, field.start, field.goal}; }

TurnRule rule_of(const Field& field) {
  return {.model = field.navigation.turn_model, .radius_m = field.navigation.turn_radius_m, .heading = std::nullopt};
}

/// Every walk over up to `most` points, judged by the contest's own rules: both errors, leg by leg.
class BruteForce {
 public:
  BruteForce(const Field& field, std::size_t most) : field_(field), most_(most) {
    fly({.at = field.start, .heading = std::nullopt, .error = {}, .length_m = 0, .corrections = 0});
  }

  /// By number of corrections: the shortest.
  std::map<int, double> best;

 private:
  struct Walk {
    Vec3 at;
    std::optional<Vec3> heading;
    NavigationError error;
    double length_m;
    int corrections;
  };

  void fly(const Walk& walk) {
    try_leg(walk, field_.goal, PointKind::end);
    if (walk.corrections == static_cast<int>(most_)) return;
    for (const CorrectionPoint& point : field_.navigation.points) try_leg(walk, point.position, point.kind);
  }

  void try_leg(const Walk& walk, const Vec3& to, PointKind kind) {
    const auto leg = walk.heading ? arc_tangent_leg({walk.at, *walk.heading}, to, field_.navigation.turn_radius_m)
                                  : straight_leg(walk.at, to);
    if (!leg) return;
    const auto error = arrive(field_.navigation, walk.error, leg->length_m, kind);
    if (!error) return;
    const double length = walk.length_m + leg->length_m;
    if (kind != PointKind::end) {
      fly({.at = to,
           .heading = leg->heading,
           .error = *error,
           .length_m = length,
           .corrections = walk.corrections + 1});
      return;
    }
    const auto [entry, is_new] = best.emplace(walk.corrections, length);
    entry->second = std::min(entry->second, length);
  }

  const Field& field_;
  std::size_t most_;
};

FrontResult find(const Field& field, bool shortest_alone = false, RunOptions options = {}) {
  Executor executor(1);
  RunContext run(executor, std::move(options));
  return turning_front(graph_of(field), rule_of(field), shortest_alone, run);
}

TEST(TurningSearch, FrontIsThatOfBruteForce) {
  int solved = 0;
  std::size_t longest_front = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Field field = small_field(seed);
    constexpr int kMost = 5;
    const BruteForce brute(field, kMost);
    const FrontResult front = find(field);
    double shortest = kInfinity;
    std::size_t expected = 0;
    for (const auto& [corrections, length] : brute.best) {
      if (length >= shortest) continue;
      shortest = length;
      ASSERT_LT(expected, front.routes.size()) << seed;
      EXPECT_EQ(static_cast<int>(front.routes[expected].points.size()), corrections) << seed;
      EXPECT_NEAR(front.routes[expected].length_m, length, 1e-8) << seed;
      ++expected;
    }
    for (std::size_t i = expected; i < front.routes.size(); ++i) EXPECT_GT(front.routes[i].points.size(), 5U) << seed;
    if (front.routes.empty()) continue;
    ++solved;
    longest_front = std::max(longest_front, front.routes.size());
    EXPECT_FALSE(front.stopped);
    EXPECT_EQ(front.bound_m, front.routes.back().length_m);
    const FrontResult alone = find(field, true);
    ASSERT_EQ(alone.routes.size(), 1U);
    EXPECT_EQ(alone.routes[0].length_m, front.bound_m);
  }
  EXPECT_GT(solved, 20);
  EXPECT_GT(longest_front, 1U);
}

TEST(TurningSearch, TurnsCanForbidWhatStraightLegsAllow) {
  int dearer = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Field field = small_field(seed);
    const FrontResult wide = find(field, true);
    field.navigation.turn_radius_m = 1e-3;
    const FrontResult straight = find(field, true);
    EXPECT_LE(straight.bound_m, wide.bound_m + 1e-9);
    dearer += straight.bound_m < wide.bound_m - 1 ? 1 : 0;
  }
  EXPECT_GT(dearer, 10);
}

TEST(TurningSearch, ProvesThatThereIsNone) {
  Field field = small_field(1);
  field.navigation.theta = 0.5;
  const FrontResult front = find(field);
  EXPECT_TRUE(front.routes.empty());
  EXPECT_FALSE(front.stopped);
  EXPECT_EQ(front.bound_m, kInfinity);
}

TEST(TurningSearch, ProvesItWhereOnlyTheTurnsForbidIt) {
  Field field;
  field.navigation = small_field(1).navigation;
  field.goal = {10000, 300, 0};
  field.navigation.points = {{.id = 0, .position = {10000, 0, 0}, .kind = PointKind::vertical}};
  field.navigation.drift_vertical = 0.00119;
  field.navigation.drift_horizontal = 0.001;
  field.navigation.theta = 11.5;
  EXPECT_TRUE(find(field).routes.empty());
  EXPECT_EQ(find(field).bound_m, kInfinity);
  field.navigation.turn_radius_m = 100;
  EXPECT_EQ(find(field).routes.size(), 1U);
}

TEST(TurningSearch, AStopLeavesAValidBound) {
  const CorrectionField drawn = draw_corrections(CorrectionLaw::set1, 3000, 1);
  Field field{.navigation = drawn.navigation, .start = drawn.start, .goal = drawn.goal};
  field.navigation.turn_model = TurnModel::arc_tangent;
  field.navigation.turn_radius_m = 200;
  std::stop_source stop;
  stop.request_stop();
  const FrontResult stopped = find(field, true, {.stop = stop.get_token()});
  EXPECT_TRUE(stopped.stopped);
  EXPECT_GE(stopped.bound_m, (field.goal - field.start).norm() * (1 - 1e-12));
  const FrontResult whole = find(field, true);
  ASSERT_EQ(whole.routes.size(), 1U);
  EXPECT_LE(stopped.bound_m, whole.bound_m);
}

TEST(TurningSearch, FreeHeadingsAreNeverLongerAndNeverBelowTheStraightBound) {
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Field field = small_field(seed);
    const FrontResult contest = find(field, true);
    field.navigation.turn_model = TurnModel::free_heading;
    const FrontResult free = find(field, true);
    field.navigation.turn_radius_m = 1e-3;
    field.navigation.turn_model = TurnModel::arc_tangent;
    const FrontResult straight = find(field, true);
    EXPECT_FALSE(free.proven);
    if (contest.routes.empty()) continue;
    ++solved;
    ASSERT_EQ(free.routes.size(), 1U);
    EXPECT_LE(free.routes[0].length_m, contest.routes[0].length_m);
    EXPECT_LE(free.bound_m, free.routes[0].length_m);
    EXPECT_NEAR(free.bound_m, straight.bound_m, 0.01);
  }
  EXPECT_GT(solved, 10);
}

}  // namespace
}  // namespace alate
