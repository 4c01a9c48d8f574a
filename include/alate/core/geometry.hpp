// Vectors, angles and distances in one metric frame: x east, y north, z up, metres, radians.
#pragma once

#include <Eigen/Core>
#include <numbers>

namespace alate {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

/// A straight piece of flight from `a` to `b`.
struct Segment {
  Vec3 a;
  Vec3 b;

  double length() const { return (b - a).norm(); }
  double planar_length() const { return (b - a).head<2>().norm(); }
  Vec3 at(double t) const { return a + t * (b - a); }
};

/// Axis-aligned rectangle, borders included.
struct Box2 {
  Vec2 min;
  Vec2 max;

  bool contains(const Vec2& p) const {
    return p.x() >= min.x() && p.x() <= max.x() && p.y() >= min.y() && p.y() <= max.y();
  }
};

/// Heading of a direction: clockwise from +y, in [0, 2 pi). Zero for a vertical direction.
double heading_of(const Vec3& direction);

/// Unit vector in the plane for a heading clockwise from +y.
Vec3 direction_of(double heading_rad);

/// Angle to the horizontal, positive upwards. Zero for a leg of no length.
double climb_angle(const Segment& leg);

/// Angle between two directions in the plane, in [0, pi]. Zero if either is vertical.
double turn_between(const Vec3& before, const Vec3& after);

/// Angle between two directions in space, in [0, pi]. Zero if either has no length.
double angle_between(const Vec3& before, const Vec3& after);

/// Smallest t in [0, 1] at which the segment is closest to `point`.
double closest_parameter(const Segment& leg, const Vec3& point);

}  // namespace alate
