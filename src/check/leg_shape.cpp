#include "check/leg_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace alate {

namespace {

constexpr double kChordError = 0.01;

const std::optional<Arc>& arc_of(const Route& route, std::size_t i) { return route.states[i].arc; }

/// Clockwise rotation by `angle`.
Vec2 turned(const Vec2& v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
}

/// Direction of flight at one of the arc's ends; `rise` is how much higher it ends than it begins.
Vec3 tangent(const Arc& arc, const Vec3& at, double rise) {
  const Vec2 out = at.head<2>() - arc.center;
  if (arc.plane) return arc.plane->normal.cross(Vec3(out.x(), out.y(), at.z() - arc.plane->center_z_m));
  const double sign = arc.angle_rad < 0 ? -1 : 1;
  return {sign * out.y(), -sign * out.x(), arc.angle_rad == 0 ? 0 : rise / std::abs(arc.angle_rad)};
}

double rise_between(const Segment& chord) { return chord.b.z() - chord.a.z(); }

}  // namespace

Vec3 point_on_leg(const Route& route, std::size_t i, double t) {
  const Segment chord = route.segment(i);
  const auto& arc = arc_of(route, i);
  if (!arc) return chord.at(t);
  if (const auto tilted = tilted_arc(route, i)) return tilted->at(t * tilted->angle_rad);
  const Vec2 out = (chord.a.head<2>() - arc->center).stableNormalized() * arc->radius_m;
  const Vec2 xy = arc->center + turned(out, arc->angle_rad * t);
  return {xy.x(), xy.y(), chord.at(t).z()};
}

double planar_length_of_leg(const Route& route, std::size_t i) {
  const auto& arc = arc_of(route, i);
  return arc ? arc->radius_m * std::abs(arc->angle_rad) : route.segment(i).planar_length();
}

double length_of_leg(const Route& route, std::size_t i) {
  const Segment chord = route.segment(i);
  const auto& arc = arc_of(route, i);
  if (!arc) return chord.length();
  return arc->plane ? arc->radius_m * arc->angle_rad : std::hypot(planar_length_of_leg(route, i), rise_between(chord));
}

double steepest_angle_of_leg(const Route& route, std::size_t i, double sign) {
  if (const auto tilted = tilted_arc(route, i)) return tilted->steepest(sign);
  return std::atan2(sign * rise_between(route.segment(i)), planar_length_of_leg(route, i));
}

Rise rise_of_leg(const Route& route, std::size_t i) {
  if (const auto tilted = tilted_arc(route, i)) return tilted->rise();
  const double rise = rise_between(route.segment(i));
  return {.up_m = std::max(0.0, rise), .down_m = std::max(0.0, -rise)};
}

std::vector<Part> parts_of_leg_between(const Route& route, std::size_t i, double floor, double top) {
  if (const auto tilted = tilted_arc(route, i)) return tilted->parts_between(floor, top);
  if (const auto part = part_between(route.segment(i), floor, top)) return {*part};
  return {};
}

Vec3 first_direction(const Route& route, std::size_t i) {
  const Segment chord = route.segment(i);
  const auto& arc = arc_of(route, i);
  return arc ? tangent(*arc, chord.a, rise_between(chord)) : Vec3(chord.b - chord.a);
}

Vec3 last_direction(const Route& route, std::size_t i) {
  const Segment chord = route.segment(i);
  const auto& arc = arc_of(route, i);
  return arc ? tangent(*arc, chord.b, rise_between(chord)) : Vec3(chord.b - chord.a);
}

double arc_gap(const Route& route, std::size_t i) {
  if (!arc_of(route, i)) return 0;
  const Segment chord = route.segment(i);
  const auto miss = [&](const Vec3& state, double t) -> double { return (point_on_leg(route, i, t) - state).norm(); };
  return std::max(miss(chord.a, 0), miss(chord.b, 1));
}

std::vector<Segment> straight_pieces(const Route& route, std::size_t i) {
  const auto& arc = arc_of(route, i);
  if (!arc) return {route.segment(i)};
  const double cosine = std::clamp(1 - kChordError / arc->radius_m, -1.0, 1.0);
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(arc->angle_rad) / (2 * std::acos(cosine)))));
  std::vector<Segment> pieces;
  Vec3 from = point_on_leg(route, i, 0);
  for (int k = 1; k <= count; ++k) {
    const Vec3 to = point_on_leg(route, i, static_cast<double>(k) / count);
    pieces.push_back({from, to});
    from = to;
  }
  return pieces;
}

}  // namespace alate
