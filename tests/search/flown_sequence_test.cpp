// Sequences of correction points where some legs are known to be longer than they look, against every sequence there
// is.
#include "search/flown_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "space/candidates.hpp"

namespace alate {
namespace {

using Node = CorrectionGraph::Node;

Navigation drawn_points(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  Navigation navigation{
      .drift_vertical = 0.001, .drift_horizontal = 0.001, .at_vertical = {9, 7}, .at_horizontal = {6, 9}, .theta = 8};
  for (int id = 1; id <= count; ++id)
    navigation.points.push_back({.id = id,
                                 .position = {between(0, 12000), between(-3000, 3000), between(0, 500)},
                                 .kind = id % 2 == 0 ? PointKind::vertical : PointKind::horizontal});
  return navigation;
}

const Vec3 kStart{0, 0, 0};
const Vec3 kGoal{12000, 0, 0};
constexpr int kMostPoints = 5;

/// Every sequence, one after the other.
class AllSequences {
 public:
  AllSequences(const CorrectionGraph& graph, const FlownLegs& flown)
      : graph_(graph), flown_(flown), nodes_{graph.start()} {}

  /// The least cost of all with at most `most` points.
  double least_cost(int most) {
    least_ = kInfinity;
    try_points(most);
    return least_;
  }

  /// With all that is known of its legs; infinite where it breaks a limit.
  double cost_of(const std::vector<Node>& nodes) const {
    double cost = 0;
    double error = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const FlownLegPrice* known = flown_.find(nodes[i < 2 ? 0 : i - 2], nodes[i - 1], nodes[i]);
      const double straight = graph_.length(nodes[i - 1], nodes[i]);
      const double length = known != nullptr ? known->length_m : straight;
      const ReducedLeg& rule = graph_.leg(nodes[i - 1], nodes[i]);
      if (!rule.keeps_limits(error, length)) return kInfinity;
      error = rule.after(error, length);
      cost += known != nullptr ? known->cost : straight;
    }
    return cost;
  }

 private:
  void try_points(int left) {
    nodes_.push_back(graph_.goal());
    least_ = std::min(least_, cost_of(nodes_));
    nodes_.pop_back();
    for (Node next = 0; left > 0 && next < graph_.point_count(); ++next) {
      if (next == nodes_.back()) continue;
      nodes_.push_back(next);
      if (cost_of(nodes_) < least_) try_points(left - 1);
      nodes_.pop_back();
    }
  }

  const CorrectionGraph& graph_;
  const FlownLegs& flown_;
  std::vector<Node> nodes_;
  double least_ = kInfinity;
};

/// Each leg that the search has taken for straight turns out to be longer, or cannot be flown at all, until it takes
/// none but known ones.
TEST(FlownSequence, IsTheCheapestWithWhatIsKnown) {
  Executor executor;
  RunContext run(executor, {});
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const CorrectionGraph graph(drawn_points(7, seed), kStart, kGoal);
    std::mt19937_64 random(seed);
    FlownLegs flown;
    for (int round = 0; round < 100; ++round) {
      AllSequences all(graph, flown);
      const double least = all.least_cost(kMostPoints);
      const auto sequence = cheapest_sequence(graph, flown, {}, run);
      EXPECT_TRUE(sequence || !(least < kInfinity)) << seed << ' ' << round;
      if (!sequence || sequence->size() > kMostPoints + 2) break;
      ++found;
      EXPECT_NEAR(all.cost_of(*sequence), least, 1e-9 * least);
      bool news = false;
      for (std::size_t i = 1; i < sequence->size(); ++i) {
        const Node before = (*sequence)[i < 2 ? 0 : i - 2];
        const Node a = (*sequence)[i - 1];
        const Node b = (*sequence)[i];
        if (flown.find(before, a, b) != nullptr) continue;
        news = true;
        const double factor = std::uniform_real_distribution(1.0, 1.3)(random);
        const bool barred = std::uniform_real_distribution(0.0, 1.0)(random) < 0.1;
        const double length = barred ? kInfinity : factor * graph.length(a, b);
        flown.note(before, a, b, {.length_m = length, .cost = 1.1 * length});
      }
      if (!news) break;
    }
  }
  EXPECT_GT(found, 60);
}

TEST(FlownSequence, IsNoneWhereErrorsForbidEveryOne) {
  Executor executor;
  RunContext run(executor, {});
  Navigation navigation = drawn_points(7, 1);
  navigation.theta = 0.1;
  EXPECT_FALSE(cheapest_sequence({navigation, kStart, kGoal}, {}, {}, run));
}

}  // namespace
}  // namespace alate
