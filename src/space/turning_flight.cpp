#include "space/turning_flight.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace alate {

namespace {

/// Heading of the straight piece of a leg that ends at `to`.
Vec3 straight_heading(const TurningLeg& leg, const Vec3& from, const Vec3& to) {
  const Vec3 begin = position_on(leg.leave, from, leg.leave.angle_rad);
  const Vec3 end = position_on(leg.arrive, to, -leg.arrive.angle_rad);
  return (end - begin).normalized();
}

TurningFlight straight_or_tangent(std::span<const Vec3> points, const TurnRule& rule) {
  TurningFlight flight;
  std::optional<Vec3> heading = rule.model == TurnModel::none ? std::nullopt : rule.heading;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto leg = heading ? arc_tangent_leg({points[i - 1], *heading}, points[i], rule.radius_m)
                             : straight_leg(points[i - 1], points[i]);
    if (!leg) break;
    flight.legs.push_back(*leg);
    flight.length_m += leg->length_m;
    if (rule.model != TurnModel::none) heading = leg->heading;
  }
  return flight;
}

/// Leg `i` with headings[i] at points[i]; the first and the last point only where one is given.
std::optional<TurningLeg> free_leg(std::span<const Vec3> points, std::span<const std::optional<Vec3>> headings,
                                   std::size_t i, double radius_m) {
  const auto& before = headings[i - 1];
  const auto& after = headings[i];
  if (before && after) return free_heading_leg({points[i - 1], *before}, {points[i], *after}, radius_m);
  if (before) return arc_tangent_leg({points[i - 1], *before}, points[i], radius_m);
  if (!after) return straight_leg(points[i - 1], points[i]);
  // Flown backwards the leg begins with its turn.
  const auto back = arc_tangent_leg({points[i], -*after}, points[i - 1], radius_m);
  if (!back) return std::nullopt;
  TurningLeg leg{.leave = {},
                 .straight_m = back->straight_m,
                 .arrive = back->leave,
                 .length_m = back->length_m,
                 .heading = *after};
  leg.arrive.normal = -leg.arrive.normal;
  return leg;
}

TurningFlight free_legs(std::span<const Vec3> points, std::span<const std::optional<Vec3>> headings, double radius_m) {
  TurningFlight flight;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto leg = free_leg(points, headings, i, radius_m);
    if (!leg) return {};
    flight.legs.push_back(*leg);
    flight.length_m += leg->length_m;
  }
  return flight;
}

/// Half way between two directions; across both where they are opposite.
Vec3 half_way(const Vec3& before, const Vec3& after) {
  const Vec3 half = (before + after).stableNormalized();
  return half.squaredNorm() > 0 ? half : before.unitOrthogonal();
}

/// Turns each interior heading half way between the straight pieces around it. Returns the largest change.
double halve_turns(std::span<const Vec3> points, const TurningFlight& flight, std::span<std::optional<Vec3>> headings) {
  double largest = 0;
  Vec3 before = straight_heading(flight.legs[0], points[0], points[1]);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 after = straight_heading(flight.legs[i], points[i], points[i + 1]);
    const Vec3 half = half_way(before, after);
    largest = std::max(largest, (half - *headings[i]).norm());
    headings[i] = half;
    before = after;
  }
  return largest;
}

TurningFlight free_headings(std::span<const Vec3> points, const TurnRule& rule) {
  constexpr int kMostRounds = 100;
  constexpr double kSettled = 1e-12;
  std::vector<std::optional<Vec3>> headings(points.size());
  const auto chord = [&](std::size_t i) -> Vec3 { return (points[i] - points[i - 1]).stableNormalized(); };
  for (std::size_t i = 1; i + 1 < points.size(); ++i) headings[i] = half_way(chord(i), chord(i + 1));
  headings.front() = rule.heading;
  TurningFlight best;
  TurningFlight flight = free_legs(points, headings, rule.radius_m);
  for (int round = 0; round < kMostRounds && !flight.legs.empty(); ++round) {
    if (best.legs.empty() || flight.length_m < best.length_m) best = flight;
    if (halve_turns(points, flight, headings) < kSettled) break;
    flight = free_legs(points, headings, rule.radius_m);
  }
  return best;
}

}  // namespace

TurnRule turn_rule(const Site& site) {
  const Mission& mission = site.mission;
  return {.model = site.navigation->turn_model,
          .radius_m = site.navigation->turn_radius_m,
          .heading = mission.heading_given ? std::optional(direction_of(mission.heading_rad)) : std::nullopt};
}

TurningFlight fly_over(std::span<const Vec3> points, const TurnRule& rule) {
  TurningFlight flight = straight_or_tangent(points, rule);
  if (rule.model != TurnModel::free_heading) return flight;
  TurningFlight free = free_headings(points, rule);
  const bool arrives = flight.legs.size() + 1 == points.size();
  return !free.legs.empty() && (!arrives || free.length_m < flight.length_m) ? free : flight;
}

}  // namespace alate
