#include "check/exposure.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "check/leg_shape.hpp"
#include "check/level_band.hpp"

namespace alate {

namespace {

/// From the threat's centre or, for a cylinder, from its axis.
Vec3 offset(const Threat& threat, const Vec3& at) {
  Vec3 result = at - threat.center;
  if (threat.shape == Threat::Shape::cylinder) result.z() = 0;
  return result;
}

/// Integral of sqrt(x^2 + q^2) from 0 to x.
double distance_integral(double x, double q) {
  const double tail = q > 0 ? q * q * std::asinh(x / q) : 0;
  return (x * std::hypot(x, q) + tail) / 2;
}

/// Mean of max(0, 1 - |a + t d|/r) dt over the part.
double straight_exposure(const Vec3& a, const Vec3& d, double radius, const Part& part) {
  const double speed = d.norm();
  if (speed == 0) return std::max(0.0, 1 - a.norm() / radius) * (part.t1 - part.t0);
  const double along = a.dot(d) / speed;
  const double q = (a - d * (along / speed)).norm();
  if (q >= radius) return 0;
  const double half = std::sqrt(radius * radius - q * q);
  const double x0 = std::max(-half, along + speed * part.t0);
  const double x1 = std::min(half, along + speed * part.t1);
  if (x0 >= x1) return 0;
  return (x1 - x0 - (distance_integral(x1, q) - distance_integral(x0, q)) / radius) / speed;
}

double arc_exposure(const Threat& threat, const Route& route, std::size_t i, const Part& part) {
  constexpr unsigned kDepth = 15;
  constexpr double kTolerance = 1e-7;
  const auto density = [&](double t) {
    return std::max(0.0, 1 - offset(threat, point_on_leg(route, i, t)).norm() / threat.radius_m);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  return Rule::integrate(density, part.t0, part.t1, kDepth, kTolerance);
}

}  // namespace

double exposure(const Threat& threat, const Route& route, std::size_t i) {
  if (threat.radius_m <= 0) return 0;
  const Segment leg = route.segment(i);
  const Vec3 a = offset(threat, leg.a);
  const Vec3 d = offset(threat, leg.b) - a;
  const bool cylinder = threat.shape == Threat::Shape::cylinder;
  double mean = 0;
  for (const Part& part : cylinder ? parts_of_leg_between(route, i, threat.floor_m, threat.top_m) : std::vector{Part{}})
    mean += route.states[i].arc ? arc_exposure(threat, route, i, part) : straight_exposure(a, d, threat.radius_m, part);
  return threat.level * length_of_leg(route, i) * mean;
}

double point_exposure(const Threat& threat, const Vec3& at) {
  const bool cylinder = threat.shape == Threat::Shape::cylinder;
  if (cylinder && (at.z() < threat.floor_m || at.z() > threat.top_m)) return 0;
  return threat.level * std::max(0.0, threat.radius_m - offset(threat, at).norm());
}

}  // namespace alate
