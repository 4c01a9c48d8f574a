#include "space/dubins/dubins_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "space/dubins/dubins_pieces.hpp"
#include "space/dubins_poses.hpp"
#include "space/dubins_reference.hpp"

namespace alate {
namespace {

using namespace dubins_test;

void expect_sound(const PlanarPose& from, const PlanarPose& to) {
  const DubinsPath path = shortest_dubins(from, to, kRadius);
  const double allowed = tolerance(from, to);
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_GE(path.lengths_m[i], 0);
    if (steering_of(path.word)[i] != Steering::straight) {
      ASSERT_LE(path.lengths_m[i], 2 * kPi * kRadius);
    }
    sum += path.lengths_m[i];
  }
  ASSERT_NEAR(path.length_m, sum, allowed);
  ASSERT_EQ(path.length_m, dubins_length(from, to, kRadius));
  ASSERT_LE(gap(pieces_of(path).back().end(), to), allowed);
  ASSERT_LE(path.length_m, reference::shortest(from, to, kRadius) + allowed);
  // Squares below 1e-308 vanish.
  ASSERT_GE(path.length_m, std::hypot(to.x - from.x, to.y - from.y) * (1 - 1e-15) - 1e-150);
  ASSERT_NEAR(path.length_m, dubins_length(reversed(to), reversed(from), kRadius), allowed);
}

/// Values at which words change, and their neighbours.
std::vector<double> near(const std::vector<double>& values, const std::vector<double>& steps) {
  std::vector<double> result;
  for (const double value : values) {
    for (const double step : steps) result.push_back(value + step);
    result.push_back(std::nextafter(value, 1e9));
    result.push_back(std::nextafter(value, -1e9));
  }
  return result;
}

TEST(Dubins, IsTheShortestOfSixWordsEverywhere) {
  Random random;
  for (const double size : {1e-3, 0.5, 2.0, 5.0, 50.0, 1e6}) {
    for (int i = 0; i < 5000; ++i) {
      const PlanarPose from = random.pose(size);
      const PlanarPose to = random.pose(size);
      SCOPED_TRACE(text(from) + " to " + text(to));
      expect_sound(from, to);
      // Away from the jumps, which have no measure, it is not shorter either.
      ASSERT_NEAR(dubins_length(from, to, kRadius), reference::shortest(from, to, kRadius), tolerance(from, to));
    }
  }
}

TEST(Dubins, IsSoundVeryNearAndFarFromTheOrigin) {
  Random random;
  for (const double size : {1e-14, 1e-12, 1e-10, 1e-9, 1e-6, 1.0, 30.0}) {
    for (int i = 0; i < 2000; ++i) {
      const PlanarPose from = random.pose(i % 2 == 0 ? 0 : 1e5);
      const PlanarPose near = random.pose(size);
      SCOPED_TRACE(text(from) + " to " + text(near) + " from there");
      expect_sound(from, planar_pose(from.x + near.x, from.y + near.y, near.heading));
      expect_sound(from, planar_pose(from.x + near.x, from.y + near.y, from.heading + 1e-10 * near.heading));
    }
  }
}

TEST(Dubins, IsSoundWhereWordsMeet) {
  const std::vector<double> headings =
      near({0, kPi / 2, -kPi / 2, kPi, -kPi, kPi / 4, 2 * kPi / 3}, {0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6});
  const std::vector<double> places =
      near({0, kRadius, -kRadius, 2 * kRadius, -2 * kRadius, 4 * kRadius}, {0, 1e-12, -1e-10, 1e-8, -1e-6});
  for (const double from : {0.0, kPi, 0.3}) {
    for (const double heading : headings) {
      for (const double x : places) {
        for (const double y : places) {
          const PlanarPose a = planar_pose(0, 0, from);
          const PlanarPose b = planar_pose(x, y, from + heading);
          SCOPED_TRACE(text(a) + " to " + text(b));
          expect_sound(a, b);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST(PlanarPiece, ComesOnlyWhereItMay) {
  Random random;
  int near = 0, far = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto steering = static_cast<Steering>(i % 3 - 1);
    const PlanarPiece piece{steering, random.pose(3), random.between(0, 6 * kRadius), kRadius};
    const Vec2 place = random.pose(6).position();
    const double reach = random.between(0, 4 * kRadius);
    double least = 1e300;
    constexpr int kSamples = 500;
    for (int k = 0; k <= kSamples; ++k)
      least = std::min(least, (piece.at(piece.length_m * k / kSamples).position() - place).norm());
    const bool may = piece.may_come_within(reach, place);
    ASSERT_TRUE(may || least >= reach) << i;
    // A straight piece is told exactly, but for what lies between samples.
    if (steering == Steering::straight) {
      ASSERT_TRUE(!may || least < reach + piece.length_m / kSamples) << i;
    }
    ++(may ? near : far);
  }
  EXPECT_GT(near, 2000);
  EXPECT_GT(far, 2000);
}

}  // namespace
}  // namespace alate
