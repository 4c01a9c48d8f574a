#include "world/threat_field.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// Part [from, to] of a leg, in its parameter; empty if from > to.
struct Span {
  double from = 0;
  double to = 1;

  bool empty() const { return from > to; }
  double length() const { return to - from; }
};

/// A leg as seen from a threat: at(t) = offset + t along, d(t) = |at(t)|.
struct View {
  Vec3 offset;
  Vec3 along;
  Span span;

  double distance(double t) const { return (offset + t * along).norm(); }
  double closest() const {
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? -offset.dot(along) / squared : 0;
    return distance(std::clamp(t, span.from, span.to));
  }
};

/// The part of the leg between two heights.
Span between(const Segment& leg, double floor, double top) {
  const double climb = leg.b.z() - leg.a.z();
  if (climb == 0) return leg.a.z() >= floor && leg.a.z() <= top ? Span{} : Span{1, 0};
  const double t_floor = (floor - leg.a.z()) / climb;
  const double t_top = (top - leg.a.z()) / climb;
  return {std::max(0.0, std::min(t_floor, t_top)), std::min(1.0, std::max(t_floor, t_top))};
}

View view_of(const Threat& threat, const Segment& leg) {
  View view{leg.a - threat.center, leg.b - leg.a, {}};
  if (threat.shape == Threat::Shape::cylinder) {
    view.span = between(leg, threat.floor_m, threat.top_m);
    view.offset.z() = 0;
    view.along.z() = 0;
  }
  return view;
}

/// The part of the view that is closer than `radius`.
Span within(const View& view, double radius) {
  const double a = view.along.squaredNorm();
  const double half_b = view.offset.dot(view.along);
  const double c = view.offset.squaredNorm() - radius * radius;
  if (a == 0) return c <= 0 ? view.span : Span{1, 0};
  const double discriminant = half_b * half_b - a * c;
  if (discriminant <= 0) return {1, 0};
  const double root = std::sqrt(discriminant);
  return {std::max(view.span.from, (-half_b - root) / a), std::min(view.span.to, (-half_b + root) / a)};
}

/// Integral of sqrt(p^2 + s^2) ds from 0 to s.
double distance_primitive(double p, double s) {
  const double d = std::hypot(p, s);
  const double bent = p > 0 ? p * p * std::asinh(s / p) : 0;
  return 0.5 * (s * d + (std::isfinite(bent) ? bent : 0));
}

/// Integral of d(t) dt over `span`.
double distance_integral(const View& view, const Span& span) {
  constexpr double kShort = 1e-3;
  const double speed = view.along.norm();
  const double middle = 0.5 * (span.from + span.to);
  const double d = view.distance(middle);
  // So short that d hardly bends: Simpson's rule is right to rounding, where the primitives would cancel.
  if (speed * span.length() <= kShort * d)
    return span.length() / 6 * (view.distance(span.from) + 4 * d + view.distance(span.to));
  const double t_closest = -view.offset.dot(view.along) / (speed * speed);
  const double p = view.distance(t_closest);
  return (distance_primitive(p, speed * (span.to - t_closest)) -
          distance_primitive(p, speed * (span.from - t_closest))) /
         speed;
}

}  // namespace

double exposure(const Threat& threat, const Segment& leg) {
  const View view = view_of(threat, leg);
  if (view.span.empty() || threat.radius_m <= 0) return 0;
  const Span span = within(view, threat.radius_m);
  if (span.empty()) return 0;
  const double integral = span.length() - distance_integral(view, span) / threat.radius_m;
  return threat.level * leg.length() * std::max(0.0, integral);
}

bool enters_core(const Threat& threat, const Segment& leg) {
  if (threat.core_m <= 0) return false;
  const View view = view_of(threat, leg);
  return !view.span.empty() && view.closest() < threat.core_m;
}

}  // namespace alate
