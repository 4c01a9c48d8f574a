#include "space/dubins/dubins_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

Vec2 PlanarArc::at(double angle_rad) const {
  return {center.x() + radius_m * std::cos(angle_rad), center.y() + radius_m * std::sin(angle_rad)};
}

PlanarArc PlanarPiece::arc() const {
  const auto side = static_cast<double>(steering);
  return {.center = {start.x - side * radius_m * start.sin, start.y + side * radius_m * start.cos},
          .radius_m = radius_m,
          .start_rad = start.heading - side * kPi / 2,
          .sweep_rad = side * length_m / radius_m};
}

bool PlanarPiece::may_come_within(double reach_m, const Vec2& place) const {
  const Vec2 way = place - start.position();
  const double along = steering == Steering::straight ? std::clamp(way.dot(start.direction()), 0.0, length_m) : 0;
  const double reach = reach_m + (steering == Steering::straight ? 0 : std::min(length_m, 2 * radius_m));
  return (way - along * start.direction()).squaredNorm() < reach * reach;
}

std::array<PlanarPiece, 3> pieces_of(const DubinsPath& path) {
  const std::array<Steering, 3> steering = steering_of(path.word);
  std::array<PlanarPiece, 3> pieces;
  PlanarPose start = path.start;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i] = {.steering = steering[i], .start = start, .length_m = path.lengths_m[i], .radius_m = path.radius_m};
    start = pieces[i].end();
  }
  return pieces;
}

PlanarPose DubinsCursor::at(double s_m) const {
  if (s_m < pieces_[0].length_m) return pieces_[0].at(s_m);
  const double rest_m = s_m - pieces_[0].length_m;
  if (rest_m < pieces_[1].length_m) return pieces_[1].at(rest_m);
  return pieces_[2].at(rest_m - pieces_[1].length_m);
}

}  // namespace alate
