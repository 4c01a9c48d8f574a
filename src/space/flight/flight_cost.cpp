#include "space/flight/flight_cost.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

FlightCost::FlightCost(const BandWalk& band)
    : band_(band),
      weights_(band.world().site().scenario.objective),
      range_m_(band.world().site().vehicle.range_m.value_or(std::numeric_limits<double>::infinity())) {
  constexpr double kSteepest = 0.2;  // few routes climb so much all the way
  in_space_ = std::hypot(1, std::min(kSteepest, std::max(band.slopes().climb, band.slopes().descent)));
}

double FlightCost::over_range(double length_m) const {
  constexpr double kDear = 100;
  if (!has_range()) return 0;
  return kDear * (weights_.length + weights_.threat) * std::max(0.0, in_space_ * length_m - range_m_);
}

double FlightCost::advance(const PlanarPiece& piece, AltitudeLabel& label) const {
  const double z = label.free;
  if (!band_.advance(piece, label)) return std::numeric_limits<double>::infinity();
  return weights_.length * piece.length_m + weights_.threat * exposure(piece, z, label.free);
}

double FlightCost::advance(const Track& track, AltitudeLabel& label) const {
  double sum = 0;
  for (const PlanarPiece& piece : track) {
    sum += advance(piece, label);
    if (!label.alive()) return std::numeric_limits<double>::infinity();
  }
  return sum;
}

bool FlightCost::near_threat(const PlanarPiece& piece) const {
  return std::ranges::any_of(band_.world().site().threats, [&](const Threat& threat) {
    return piece.may_come_within(threat.radius_m, threat.center.head<2>());
  });
}

/// Along chords of at most an eighth of a circle.
double FlightCost::exposure(const PlanarPiece& piece, double z_from, double z_to) const {
  if (!near_threat(piece)) return 0;
  const double most = piece.steering == Steering::straight ? piece.length_m : band_.radius_m() * kPi / 4;
  const int count = std::max(1, static_cast<int>(std::ceil(piece.length_m / most)));
  const PlanarMotion motion = planar_motion(piece.steering, piece.length_m / count, band_.radius_m());
  PlanarPose at = piece.start;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const PlanarPose next = moved(at, motion);
    const double z_a = z_from + (z_to - z_from) * k / count;
    const double z_b = z_from + (z_to - z_from) * (k + 1) / count;
    sum += band_.world().exposure({{at.x, at.y, z_a}, {next.x, next.y, z_b}});
    at = next;
  }
  return sum;
}

}  // namespace alate
