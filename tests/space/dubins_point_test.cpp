#include "space/dubins/dubins_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "space/dubins/dubins_pieces.hpp"
#include "space/dubins_poses.hpp"

namespace alate {
namespace {

using namespace dubins_test;

/// Shortest over many headings, then over ever finer ones around the best.
double over_headings(const PlanarPose& from, const PlanarPose& to) {
  constexpr int kHeadings = 720;
  double best = std::numeric_limits<double>::infinity();
  double middle = 0;
  for (double width = kPi; width > 1e-7; width /= 50) {
    const double around = middle;
    for (int k = -kHeadings; k <= kHeadings; ++k) {
      const double heading = around + width * k / kHeadings;
      const double length = dubins_length(from, planar_pose(to.x, to.y, heading), kRadius);
      if (length < best) {
        best = length;
        middle = heading;
      }
    }
  }
  return best;
}

TEST(DubinsPoint, IsTheShortestOverAllHeadings) {
  Random random;
  for (int i = 0; i < 300; ++i) {
    const PlanarPose from = random.pose(1.5);
    const PlanarPose to = random.pose(i % 2 == 0 ? 1.5 : 20);
    const DubinsPath path = shortest_dubins_to_point(from, to.position(), kRadius);
    ASSERT_NEAR(path.length_m, over_headings(from, to), 1e-4) << text(from) << " to " << text(to);
    ASSERT_LE(path.length_m, dubins_length(from, to, kRadius) + 1e-9 * kRadius);
    ASSERT_LE((pieces_of(path).back().end().position() - to.position()).norm(), 1e-9 * kRadius);
    ASSERT_GE(path.length_m, (to.position() - from.position()).norm());
  }
}

TEST(DubinsPoint, FromAPointIsTheOtherWayRound) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const PlanarPose from = random.pose(3);
    const PlanarPose to = random.pose(3);
    const DubinsPath path = shortest_dubins_from_point(from.position(), to, kRadius);
    ASSERT_EQ(path.start.position(), from.position());
    ASSERT_LE(gap(pieces_of(path).back().end(), to), 1e-8 * kRadius) << text(from) << " to " << text(to);
    ASSERT_LE(path.length_m, dubins_length(from, to, kRadius) + 1e-9 * kRadius);
    ASSERT_NEAR(path.length_m, shortest_dubins(path.start, to, kRadius).length_m, 1e-6);
  }
}

TEST(DubinsPoint, AheadIsStraight) {
  const PlanarPose from = planar_pose(10, 20, 2);
  for (const double ahead : {0.0, 1e-9, 1.0, 1e5}) {
    const Vec2 to = from.position() + ahead * from.direction();
    EXPECT_NEAR(shortest_dubins_to_point(from, to, kRadius).length_m, ahead, 1e-9 * (1 + ahead));
  }
}

TEST(DubinsPieces, ArcsAndPosesAgree) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    const PlanarPose from = random.pose(3);
    const PlanarPose to = random.pose(3);
    const DubinsPath path = shortest_dubins(from, to, kRadius);
    const DubinsCursor cursor(path);
    double before_m = 0;
    for (const PlanarPiece& piece : cursor.pieces()) {
      const PlanarPose middle = cursor.at(before_m + 0.3 * piece.length_m);
      ASSERT_LE(gap(middle, piece.at(0.3 * piece.length_m)), 1e-9);
      if (piece.steering != Steering::straight) {
        const PlanarArc arc = piece.arc();
        ASSERT_LE((arc.at(arc.start_rad + 0.3 * arc.sweep_rad) - middle.position()).norm(), 1e-9);
      } else {
        ASSERT_NEAR((piece.end().position() - piece.start.position()).norm(), piece.length_m, 1e-9);
      }
      before_m += piece.length_m;
    }
    ASSERT_LE(gap(cursor.at(0), from), 1e-12);
    ASSERT_LE(gap(cursor.at(path.length_m), to), 1e-6);
  }
}

}  // namespace
}  // namespace alate
