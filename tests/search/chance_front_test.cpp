#include "search/label_setting/chance_front.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "correction_oracles.hpp"

namespace alate {
namespace {

using test::expect_same_front;
using test::FrontValue;

class ChanceFront : public testing::Test {
 protected:
  FrontResult front(const CorrectionField& field) {
    return chance_front({field.navigation, field.start, field.goal}, run_);
  }

  Executor executor_{1};
  RunContext run_{executor_, {}};
};

/// Share of flights without a broken limit.
double fly_often(const CorrectionField& field, const std::vector<CorrectionPoint>& points, int flights) {
  int arrived = 0;
  for (int flight = 0; flight < flights; ++flight) {
    Stream stream(7, 0, static_cast<std::uint64_t>(flight));
    double vertical = 0;
    double horizontal = 0;
    Vec3 at = field.start;
    bool ok = true;
    for (const CorrectionPoint& point : points) {
      const double d = (point.position - at).norm();
      at = point.position;
      vertical += field.navigation.drift_vertical * d;
      horizontal += field.navigation.drift_horizontal * d;
      const bool is_vertical = point.kind == PointKind::vertical;
      const auto& most = is_vertical ? field.navigation.at_vertical : field.navigation.at_horizontal;
      ok = ok && vertical <= most.vertical && horizontal <= most.horizontal;
      double& error = is_vertical ? vertical : horizontal;
      error = stream.uniform() < point.success ? 0 : std::min(error, field.navigation.residual);
    }
    const double home = (field.goal - at).norm();
    ok = ok && vertical + field.navigation.drift_vertical * home < field.navigation.theta &&
         horizontal + field.navigation.drift_horizontal * home < field.navigation.theta;
    arrived += ok ? 1 : 0;
  }
  return static_cast<double>(arrived) / flights;
}

TEST_F(ChanceFront, FindsWhatTryingEverythingFinds) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const CorrectionField field = test::small_field(40, 62'000, seed);
    constexpr std::size_t kMost = 6;
    auto ours = test::values_of(field, front(field));
    std::erase_if(ours, [](const FrontValue& one) { return one.corrections > static_cast<int>(kMost); });
    expect_same_front(ours, test::brute_force_front(field, kMost, true), "seed " + std::to_string(seed));
    longest = std::max(longest, ours.size());
  }
  EXPECT_GE(longest, 5U);
}

TEST_F(ChanceFront, FindsItWhereEveryCorrectionMayFail) {
  std::size_t routes = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CorrectionField field = test::small_field(25, 58'000, seed);
    for (CorrectionPoint& point : field.navigation.points) point.success = point.id % 2 == 0 ? 0.8 : 0.9;
    constexpr std::size_t kMost = 6;
    auto ours = test::values_of(field, front(field));
    std::erase_if(ours, [](const FrontValue& one) { return one.corrections > static_cast<int>(kMost); });
    expect_same_front(ours, test::brute_force_front(field, kMost, true), "seed " + std::to_string(seed));
    routes += ours.size();
  }
  EXPECT_GT(routes, 40U);
}

TEST_F(ChanceFront, AgreesWithManyFlights) {
  constexpr int kFlights = 20'000;
  int between = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const CorrectionField field = draw_corrections(CorrectionLaw::set2, 325, seed);
    const FrontResult result = front(field);
    for (const CorrectionRoute& route : result.routes) {
      const double p = success_probability(field.navigation, field.start, field.goal, route.points);
      const double deviation = std::sqrt(p * (1 - p) / kFlights);
      EXPECT_NEAR(fly_often(field, route.points, kFlights), p, 5 * deviation + 1e-12) << seed;
      between += p > 0.01 && p < 0.99 ? 1 : 0;
    }
  }
  EXPECT_GT(between, 10);
}

/// With certainty asked for, the worst case rules: every correction that may fail does.
TEST_F(ChanceFront, SureRoutesKeepTheLimitsWhenEverythingFails) {
  int sure = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CorrectionField field = draw_corrections(CorrectionLaw::set1, 611, seed);
    for (const CorrectionRoute& route : front(field).routes) {
      std::vector<CorrectionPoint> worst = route.points;
      for (CorrectionPoint& point : worst) point.success = point.success < 1 ? 0 : 1;
      const double p = success_probability(field.navigation, field.start, field.goal, route.points);
      EXPECT_EQ(success_probability(field.navigation, field.start, field.goal, worst), p > 1 - 1e-9 ? 1 : 0);
      sure += p > 1 - 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GE(sure, 10);
}

TEST_F(ChanceFront, WithReliablePointsItIsTheFrontOfProblemOne) {
  const CorrectionField field = test::never_failing(draw_corrections(CorrectionLaw::set1, 611, 3));
  const CorrectionGraph graph(field.navigation, field.start, field.goal);
  expect_same_front(test::values_of(field, front(field)), test::values_of(field, correction_front(graph, run_)), "");
}

TEST_F(ChanceFront, NoPublishedRouteBeatsIt) {
  ALATE_NEEDS_CONTEST_POINTS;
  const std::vector<std::pair<CorrectionLaw, std::vector<int>>> published{
      {CorrectionLaw::set1, {503, 294, 91, 607, 61, 250, 369, 566, 400}},
      {CorrectionLaw::set1, {503, 200, 136, 80, 237, 278, 375, 172, 340, 277, 370}},
      {CorrectionLaw::set2,
       {140, 226, 288, 306, 237, 280, 65, 142, 310, 7, 145, 293, 156, 213, 164, 50, 247, 38, 110, 99, 292}}};
  for (const auto& [law, ids] : published) {
    const CorrectionField field = test::contest_field(law);
    std::vector<CorrectionPoint> points;
    FrontValue value{.corrections = static_cast<int>(ids.size())};
    Vec3 at = field.start;
    for (const int id : ids) {
      points.push_back(*std::ranges::find(field.navigation.points, id, &CorrectionPoint::id));
      value.length_m += (points.back().position - at).norm();
      at = points.back().position;
    }
    value.length_m += (field.goal - at).norm();
    value.probability = success_probability(field.navigation, field.start, field.goal, points);
    EXPECT_GT(value.probability, 0);
    const auto ours = test::values_of(field, front(field));
    EXPECT_TRUE(std::ranges::any_of(ours, [&](const FrontValue& one) { return one.is_as_good_as(value); }));
  }
}

}  // namespace
}  // namespace alate
