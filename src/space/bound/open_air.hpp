// Which altitudes are open over a piece of the plane, always on the safe side of a proof: never fewer than there are.
#pragma once

#include "alate/data/site.hpp"
#include "space/flight/altitude_label.hpp"

namespace alate {

/// Closed interval of altitudes, metres; empty where low > high.
struct Altitudes {
  double low = 0;
  double high = 0;

  bool any() const { return low <= high; }
  bool overlap(const Altitudes& other) const { return low <= other.high && other.low <= high; }
};

/// How ground without data counts. Planners treat it as closed; what holds with open voids holds whatever lies there.
enum class Voids { closed, open };

/// Lowest and highest known ground over a rectangle or along a line, at least as far apart as the truth.
struct GroundRange {
  double low = 0;
  double high = 0;  ///< Below `low` where nothing is known.
  bool has_voids = false;
};

/// Borrows the site, which must have ground and outlive this.
class OpenAir {
 public:
  /// Routes are judged along chords this close to their arcs, and with a tolerance far below it.
  static constexpr double kSlack_m = 0.05;

  explicit OpenAir(const Site& site, Voids voids = Voids::closed) : site_(site), voids_(voids) {}

  /// Of the ground, in the frame.
  Box2 area() const;
  /// The hull of all altitudes that the band and the cores leave open somewhere over `box`.
  Altitudes over(const Box2& box) const;
  /// Along a straight line: exact where the ground is a raster.
  Altitudes along(const Vec2& a, const Vec2& b) const;

 private:
  Altitudes open_above(const GroundRange& ground) const;
  template <class Farthest>
  void close_cores(const Farthest& farthest, Altitudes& open) const;

  const Site& site_;
  Voids voids_;
};

/// Slope limits of the vehicle that no rounding makes too small; infinite where none is given.
SlopeLimits optimistic_slopes(const Vehicle& vehicle);

/// Distance from a point to a rectangle; 0 inside.
double distance_to(const Box2& box, const Vec2& point);

}  // namespace alate
