// What a flight over a track costs under the physical objective, as far as it is known before its altitudes are.
#pragma once

#include <cmath>
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
  bool has_range() const { return std::isfinite(range_m_); }
  /// What a whole way costs more, so many metres long seen from above, for what may lie beyond the aircraft's range:
  /// far more than flying so long could save.
  double over_range(double length_m) const;

  /// Metres of exposure, at altitudes that change evenly along the piece; not weighed.
  double exposure(const PlanarPiece& piece, double z_from, double z_to) const;

 private:
  const BandWalk& band_;
  ObjectiveSpec weights_;
  double range_m_;
  double in_space_ = 1;  ///< Metres in space for one seen from above, at most.
};

}  // namespace alate
