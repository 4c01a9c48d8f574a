// Flights that nobody planned.
#pragma once

#include "alate/core/stream.hpp"
#include "space/flight/band_walk.hpp"

namespace alate::test {

struct Flown {
  Track track;
  AltitudeLabel label;
};

/// A track drawn piece by piece from a random place, as long as some altitude is left.
inline Flown draw_track(const BandWalk& band, const PlanarPose& start, double z, Stream& random) {
  Flown flown{.track = {}, .label = AltitudeLabel::at(z)};
  PlanarPose at = start;
  for (int k = 0; k < 30; ++k) {
    const auto steering = static_cast<Steering>(static_cast<int>(random.below(3)) - 1);
    const double most = steering == Steering::straight ? 600 : 1.5 * band.radius_m();
    const PlanarPiece piece{steering, at, 1 + most * random.uniform(), band.radius_m()};
    AltitudeLabel label = flown.label;
    if (!band.advance(piece, label)) continue;
    flown.label = label;
    flown.track.push_back(piece);
    at = piece.end();
  }
  return flown;
}

}  // namespace alate::test
