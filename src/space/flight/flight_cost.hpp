// What a flight over a track costs under the physical objective, as far as it is known before its altitudes are.
#pragma once

#include <vector>

#include "space/flight/band_walk.hpp"

namespace alate {

/// Length seen from above and exposure at the altitudes that cost no ascent; ascent is the label's. World and band must
/// outlive this.
class FlightCost {
 public:
  explicit FlightCost(const BandWalk& band);

  const BandWalk& band() const { return band_; }
  double length_weight() const { return weights_.length; }
  double climb_weight() const { return weights_.climb; }
  double threat_weight() const { return weights_.threat; }
  /// False where surely no threat sees any of it.
  bool near_threat(const PlanarPiece& piece) const;

  /// Advances the label; its cost without ascent, infinite if no altitude is left.
  double advance(const PlanarPiece& piece, AltitudeLabel& label) const;
  double advance(const Track& track, AltitudeLabel& label) const;
  /// Metres of exposure, at altitudes that change evenly along the piece; not weighed.
  double exposure(const PlanarPiece& piece, double z_from, double z_to) const;

 private:
  const BandWalk& band_;
  ObjectiveSpec weights_;
};

}  // namespace alate
