#include "data/correction_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace alate {
namespace {

TEST(CorrectionLaw, KeepsTheContestsDensityEndsAndHalves) {
  const CorrectionField field = draw_corrections(CorrectionLaw::set2, 1300, 4);
  EXPECT_NEAR(field.goal.x(), 200'000, 0.01);
  EXPECT_EQ(field.start, Vec3(0, 100'000, 5'000));
  EXPECT_EQ(field.goal.y(), 120'000);
  EXPECT_EQ(field.navigation.goal_id, 1301);
  const auto& points = field.navigation.points;
  ASSERT_EQ(points.size(), 1300U);
  EXPECT_EQ(points.front().id, 1);
  EXPECT_EQ(points.back().id, 1300);
  EXPECT_EQ(std::ranges::count(points, PointKind::vertical, &CorrectionPoint::kind), 650);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(points, 0.8, &CorrectionPoint::success)), 325, 2);
  for (const CorrectionPoint& point : points) {
    EXPECT_TRUE((point.position.array() >= 0).all());
    EXPECT_LE(point.position.head<2>().maxCoeff(), 200'000);
    EXPECT_LE(point.position.z(), 10'000);
    EXPECT_EQ(point.position.x(), std::round(point.position.x() * 100) / 100);
  }
}

TEST(CorrectionLaw, IsAFunctionOfTheSeed) {
  const auto first = [](std::uint64_t seed) {
    return draw_corrections(CorrectionLaw::set1, 3, seed).navigation.points[0].position;
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_NE(first(1), first(2));
}

}  // namespace
}  // namespace alate
