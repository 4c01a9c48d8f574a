#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "world/threat_field.hpp"

namespace alate {
namespace {

Threat sphere(const Vec3& center, double radius, double core) {
  return {.name = "sphere", .center = center, .radius_m = radius, .level = 0.7, .core_m = core};
}

Threat cylinder(const Vec3& center, double radius, double core, double top) {
  return {.name = "cylinder",
          .shape = Threat::Shape::cylinder,
          .center = center,
          .radius_m = radius,
          .level = 0.7,
          .core_m = core,
          .floor_m = center.z(),
          .top_m = top};
}

double distance(const Threat& threat, const Vec3& at) {
  if (threat.shape == Threat::Shape::sphere) return (at - threat.center).norm();
  return at.z() >= threat.floor_m && at.z() <= threat.top_m ? (at - threat.center).head<2>().norm() : 1e9;
}

double summed_exposure(const Threat& threat, const Segment& leg) {
  constexpr int kSteps = 20'000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    sum += std::max(0.0, 1 - distance(threat, leg.at((i + 0.5) / kSteps)) / threat.radius_m);
  return threat.level * leg.length() * sum / kSteps;
}

Segment random_leg(Stream& stream) {
  const auto point = [&]() -> Vec3 {
    return 200 * (Vec3(stream.uniform(), stream.uniform(), stream.uniform()) * 2 - Vec3::Ones());
  };
  const Vec3 a = point();
  return {a, point()};
}

TEST(Threat, ExposureAgreesWithASum) {
  for (const Threat& threat : {sphere({10, -20, 5}, 120, 0), cylinder({-10, 0, -60}, 150, 0, 70)}) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      Stream stream(1, 1, i);
      const Segment leg = random_leg(stream);
      EXPECT_NEAR(exposure(threat, leg), summed_exposure(threat, leg), 0.02) << i;
    }
  }
}

TEST(Threat, ExposureThroughTheCentreIsHalfTheDiameter) {
  EXPECT_NEAR(exposure(sphere({0, 0, 0}, 100, 0), {{-500, 0, 0}, {500, 0, 0}}), 0.7 * 100, 1e-9);
  EXPECT_NEAR(exposure(cylinder({0, 0, 0}, 100, 0, 50), {{0, -500, 20}, {0, 500, 20}}), 0.7 * 100, 1e-9);
}

TEST(Threat, ExposureAddsUpOverTheParts) {
  const Threat threat = sphere({3, 4, 5}, 130, 0);
  for (std::uint64_t i = 0; i < 200; ++i) {
    Stream stream(1, 2, i);
    const Segment leg = random_leg(stream);
    const double cut = stream.uniform();
    EXPECT_NEAR(exposure(threat, leg), exposure(threat, {leg.a, leg.at(cut)}) + exposure(threat, {leg.at(cut), leg.b}),
                1e-8);
  }
}

TEST(Threat, LegsOfNoOrHardlyAnyLengthAreSafe) {
  const Threat ball = sphere({0, 0, 0}, 100, 10);
  const Threat tube = cylinder({0, 0, 0}, 100, 10, 50);
  const Vec3 at{30, 40, 20};
  for (const Threat& threat : {ball, tube}) {
    EXPECT_EQ(exposure(threat, {at, at}), 0);
    EXPECT_NEAR(exposure(threat, {at, at + Vec3(1e-7, 0, 0)}), 1e-7 * 0.7 * (1 - distance(threat, at) / 100), 1e-12);
    EXPECT_EQ(exposure(threat, {Vec3::Zero(), Vec3::Zero()}), 0);
  }
  // Straight up beside the axis: the distance stays, only the part below the top counts.
  EXPECT_NEAR(exposure(tube, {{30, 40, -100}, {30, 40, 100}}), 0.7 * 50 * 0.5, 1e-9);
  EXPECT_NEAR(exposure(tube, {{30, 40, -100}, {30 + 1e-9, 40, 100}}), 0.7 * 50 * 0.5, 1e-7);
}

TEST(Threat, CoresAgreeWithDenseSampling) {
  for (const Threat& threat : {sphere({10, -20, 5}, 120, 60), cylinder({-10, 0, -60}, 150, 50, 70)}) {
    int entered = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      Stream stream(1, 3, i);
      const Segment leg = random_leg(stream);
      double nearest = 1e9;
      for (int k = 0; k <= 2000; ++k) nearest = std::min(nearest, distance(threat, leg.at(k / 2000.0)));
      const bool enters = enters_core(threat, leg);
      entered += enters ? 1 : 0;
      if (nearest < threat.core_m) {
        EXPECT_TRUE(enters) << i;
      }
      // What sampling misses lies within half a step of it.
      if (nearest > threat.core_m + 1 && threat.shape == Threat::Shape::sphere) {
        EXPECT_FALSE(enters) << i;
      }
    }
    EXPECT_GT(entered, 100);
    EXPECT_LT(entered, 1900);
  }
}

TEST(Threat, WithoutACoreNothingIsEntered) {
  EXPECT_FALSE(enters_core(sphere({0, 0, 0}, 100, 0), {{-1, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(enters_core(cylinder({0, 0, 0}, 100, 20, 50), {{-100, 0, 51}, {100, 0, 51}}));
  EXPECT_TRUE(enters_core(cylinder({0, 0, 0}, 100, 20, 50), {{0, 0, 100}, {0, 0, 49}}));
}

}  // namespace
}  // namespace alate
