#include "space/rotations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <tuple>

#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

using Eigen::AngleAxisd;

/// The paper's way: three rotations, each about the axis that the rotations before have turned (eqs. (15)-(21)).
Mat3 rotate_successively(const Mat3& start, const AttitudeAction& action) {
  const Mat3 rolled = AngleAxisd(action.roll_rad, start.col(0)).toRotationMatrix() * start;
  const Mat3 pitched = AngleAxisd(-action.pitch_rad, rolled.col(1)).toRotationMatrix() * rolled;
  return AngleAxisd(-action.yaw_rad, pitched.col(2)).toRotationMatrix() * pitched;
}

TEST(Rotations, OneProductEqualsThreeSuccessiveRotations) {
  const RotationSet set(test::konatowski_site(0.5, {}).vehicle);
  Mat3 attitude = level_attitude(radians(200));
  for (std::size_t k = 0; k < set.size(); ++k) {
    EXPECT_LT((rotate_successively(attitude, set.action(k)) - attitude * set.matrix(k)).norm(), 1e-13);
    attitude = attitude * set.matrix(k);
  }
}

TEST(Rotations, SignsAreThoseOfTheScenario) {
  EXPECT_LT((level_attitude(radians(90)) - Mat3::Identity()).norm(), 1e-15);
  EXPECT_LT((level_attitude(radians(225)).col(0) - direction_of(radians(225))).norm(), 1e-15);
  EXPECT_GT(body_rotation({.pitch_rad = 0.1}).col(0).z(), 0) << "nose up";
  EXPECT_LT(body_rotation({.yaw_rad = 0.1}).col(0).y(), 0) << "nose right: left is +y";
  EXPECT_GT(body_rotation({.roll_rad = 0.1}).col(1).z(), 0) << "right wing down: the left one rises";
}

TEST(Rotations, ThePapersSetHas125ActionsIn121Directions) {
  const RotationSet set(test::konatowski_site(0.5, {}).vehicle);
  EXPECT_EQ(set.size(), 125U);
  std::set<std::tuple<long, long, long>> directions;
  const auto key = [](double value) { return std::lround(value * 1e12); };
  for (std::size_t k = 0; k < set.size(); ++k)
    directions.insert({key(set.forward_x()[k]), key(set.forward_y()[k]), key(set.forward_z()[k])});
  EXPECT_EQ(directions.size(), 121U);
  EXPECT_NEAR(degrees(set.largest_turn()), 21.09, 0.005);
}

}  // namespace
}  // namespace alate
