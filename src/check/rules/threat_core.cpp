#include <algorithm>
#include <cmath>

#include "check/level_band.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

struct Nearest {
  double distance_m;
  Vec3 where;
};

Nearest nearest_to_point(const Segment& piece, const Vec3& point) {
  const Vec3 at = piece.at(closest_parameter(piece, point));
  return {(at - point).norm(), at};
}

/// Closest approach to the upright line through `axis`.
Nearest nearest_to_axis(const Segment& piece, const Vec3& axis) {
  const auto flat = [](const Vec3& p) { return Vec3(p.x(), p.y(), 0); };
  const Segment shadow{flat(piece.a), flat(piece.b)};
  const double t = closest_parameter(shadow, flat(axis));
  return {(shadow.at(t) - flat(axis)).norm(), piece.at(t)};
}

Nearest nearest_to_cylinder(const Segment& piece, const Threat& threat) {
  const auto part = part_between(piece, threat.floor_m, threat.top_m);
  if (part) return nearest_to_axis({piece.at(part->t0), piece.at(part->t1)}, threat.center);
  const auto [low, high] = std::minmax(piece.a.z(), piece.b.z());
  const double gap = std::max(low - threat.top_m, threat.floor_m - high);
  Nearest nearest = nearest_to_axis(piece, threat.center);
  nearest.distance_m = std::max(nearest.distance_m, threat.core_m + gap);
  return nearest;
}

}  // namespace

RuleReport judge_threat_core(const Flight& flight) {
  RuleReport report("threat_core");
  const auto& threats = flight.site.threats;
  if (std::ranges::none_of(threats, [](const Threat& t) { return t.core_m > 0; })) {
    report.not_checked("no threat has a core_m");
  }
  for (const Leg& leg : flight.legs) {
    for (const Segment& piece : leg.pieces) {
      for (const Threat& threat : threats) {
        if (threat.core_m <= 0) continue;
        const bool sphere = threat.shape == Threat::Shape::sphere;
        const Nearest near = sphere ? nearest_to_point(piece, threat.center) : nearest_to_cylinder(piece, threat);
        report.at_least({.leg = leg.index, .where = near.where, .value = near.distance_m, .limit = threat.core_m});
      }
    }
  }
  return report;
}

}  // namespace alate
