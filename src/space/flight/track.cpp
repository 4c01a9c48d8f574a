#include "space/flight/track.hpp"

namespace alate {

double length_of(const Track& track) {
  double sum = 0;
  for (const PlanarPiece& piece : track) sum += piece.length_m;
  return sum;
}

PlanarPiece reversed(const PlanarPiece& piece) {
  return {.steering = static_cast<Steering>(-static_cast<int>(piece.steering)),
          .start = reversed(piece.end()),
          .length_m = piece.length_m,
          .radius_m = piece.radius_m};
}

void append(Track& track, const DubinsPath& path) {
  constexpr double kNoLength_m = 1e-6;
  for (const PlanarPiece& piece : pieces_of(path))
    if (piece.length_m > kNoLength_m) track.push_back(piece);
}

}  // namespace alate
