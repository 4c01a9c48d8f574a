#include "check/tilted_arc.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// The angle's equal in [0, 2 pi).
double turned_up(double angle) {
  const double rest = std::fmod(angle, 2 * kPi);
  return rest < 0 ? rest + 2 * kPi : rest;
}

}  // namespace

Vec3 TiltedArc::at(double s) const { return center + radius_m * (std::cos(s) * out + std::sin(s) * along); }

Vec3 TiltedArc::direction(double s) const { return std::cos(s) * along - std::sin(s) * out; }

double TiltedArc::steepest(double sign) const {
  const double summit = turned_up(std::atan2(-sign * out.z(), sign * along.z()));
  const double sine = summit <= angle_rad ? std::hypot(out.z(), along.z())
                                          : std::max(sign * along.z(), sign * direction(angle_rad).z());
  return std::asin(std::clamp(sine, -1.0, 1.0));
}

Rise TiltedArc::rise() const {
  Rise rise;
  double from = 0;
  double turn = turned_up(std::atan2(along.z(), out.z()));
  if (turn > kPi) turn -= kPi;
  for (; from < angle_rad; turn += kPi) {
    const double to = std::min(turn, angle_rad);
    const double climb = at(to).z() - at(from).z();
    (climb > 0 ? rise.up_m : rise.down_m) += std::abs(climb);
    from = to;
  }
  return rise;
}

std::vector<Part> TiltedArc::parts_between(double floor, double top) const {
  std::vector<double> cuts{0, angle_rad};
  const double swing = radius_m * std::hypot(out.z(), along.z());
  const double summit = std::atan2(along.z(), out.z());
  for (const double height : {floor, top}) {
    const double cosine = (height - center.z()) / swing;
    if (!(std::abs(cosine) < 1)) continue;
    for (const double side : {-1.0, 1.0}) {
      for (double s = turned_up(summit + side * std::acos(cosine)); s < angle_rad; s += 2 * kPi) cuts.push_back(s);
    }
  }
  std::ranges::sort(cuts);
  std::vector<Part> parts;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    const double middle = at((cuts[k - 1] + cuts[k]) / 2).z();
    if (middle >= floor && middle <= top) parts.push_back({cuts[k - 1] / angle_rad, cuts[k] / angle_rad});
  }
  return parts;
}

std::optional<TiltedArc> tilted_arc(const Route& route, std::size_t i) {
  const auto& arc = route.states[i].arc;
  if (!arc || !arc->plane) return std::nullopt;
  const Vec3 center{arc->center.x(), arc->center.y(), arc->plane->center_z_m};
  const Vec3& normal = arc->plane->normal;
  const Vec3 offset = route.states[i - 1].position - center;
  const Vec3 out = (offset - normal.dot(offset) * normal).stableNormalized();
  return TiltedArc{
      .center = center, .out = out, .along = normal.cross(out), .radius_m = arc->radius_m, .angle_rad = arc->angle_rad};
}

}  // namespace alate
