// The band of altitudes along a ground track, cut finely enough to be straight: what every test of a flight over real
// ground comes down to.
//
// Along a straight line the bilinear ground of a cell is a quadratic, which lies between two straight lines: its chord,
// and the chord moved by a quarter of its curvature. Arcs are cut into chords that stay within kSagitta_m of them, and
// the ground is taken as so much higher and lower as its steepest slope rises on that way. So whatever keeps the band
// given here keeps that of the scenario, exactly, for any chords that a check may cut within kSagitta_m.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "alate/world/world.hpp"
#include "space/flight/altitude_label.hpp"
#include "space/flight/track.hpp"
#include "world/cell_walk.hpp"

namespace alate {

/// A stretch of track over which floor and ceiling are straight.
struct BandPiece {
  double length_m = 0;
  double floor_from = 0, floor_to = 0;
  double ceiling_from = 0, ceiling_to = 0;
};

/// Immutable. World must outlive it. Cores of threats count as closed from below their top down to the ground, flown
/// over but not under: a route under a floating core is not found.
class BandWalk {
 public:
  static constexpr double kSagitta_m = 0.05;

  /// The vehicle must have a turn radius.
  explicit BandWalk(const World& world);

  const World& world() const { return world_; }
  /// Of the circles that are flown: a little more than the least that the vehicle can.
  double radius_m() const { return radius_m_; }
  const SlopeLimits& slopes() const { return slopes_; }
  /// Altitudes that may be open at a place: none that is open is left out.
  std::pair<double, double> open_at(const Vec2& place) const;
  /// The same band for flights the other way: climbs are descents there.
  BandWalk homeward() const {
    BandWalk other(*this);
    other.slopes_ = slopes_.reversed();
    return other;
  }

  /// Calls visit(BandPiece) from begin to end; false as soon as the ground ends, is unknown, or `visit` returns false.
  template <class Visit>
  bool follow(const PlanarPiece& piece, const Visit& visit) const {
    const double chord_m = piece.steering == Steering::straight ? piece.length_m : most_chord_m_;
    const int count = std::max(1, static_cast<int>(std::ceil(piece.length_m / chord_m)));
    const double step_m = piece.length_m / count;
    const bool is_arc = piece.steering != Steering::straight;
    const PlanarMotion motion = planar_motion(piece.steering, step_m, radius_m_);
    const bool near_core = is_near_core(piece);
    Vec2 at = piece.start.position();
    Vec2 chord = motion.chord_m * turned(piece.start.direction(), motion);
    for (int k = 0; k < count; ++k) {
      const Vec2 next = at + chord;
      if (!follow_chord({at, next, step_m, is_arc, near_core}, visit)) return false;
      at = next;
      if (is_arc) chord = turned(turned(chord, motion), motion);
    }
    return true;
  }

  /// Onward along a piece; false if no altitude is left.
  bool advance(const PlanarPiece& piece, AltitudeLabel& label) const {
    return follow(piece, [&](const BandPiece& band) { return pass(band, label); });
  }
  /// Backward along a piece, from its end to its begin.
  bool advance(const PlanarPiece& piece, BackwardLabel& label) const {
    return follow(reversed(piece), [&](const BandPiece& band) { return pass(band, label); });
  }

 private:
  struct Chord {
    Vec2 from, to;
    double length_m;
    bool is_arc;
    bool near_core;
  };
  /// Ground between two straight lines, t in [0, 1] of a chord.
  struct GroundSpan {
    double t_from = 0, t_to = 1;
    double from = 0, to = 0;
    double bulge = 0;  ///< How far the quadratic goes above (positive) or below its chord.
  };

  /// A label that is dead at the begin of a stretch would come to life again further on.
  template <class Label>
  bool pass(const BandPiece& band, Label& label) const {
    label.clip(band.floor_from, band.ceiling_from);
    if (!label.alive()) return false;
    label.advance(band.length_m, slopes_);
    label.clip(band.floor_to, band.ceiling_to);
    return label.alive();
  }

  template <class Visit>
  bool follow_chord(const Chord& chord, const Visit& visit) const {
    if (raster_ != nullptr) return follow_raster(chord, visit);
    return follow_smooth(chord, visit);
  }
  template <class Visit>
  bool follow_raster(const Chord& chord, const Visit& visit) const;
  template <class Visit>
  bool follow_smooth(const Chord& chord, const Visit& visit) const;

  /// By half the turn of a motion.
  static Vec2 turned(const Vec2& v, const PlanarMotion& motion) {
    return {v.x() * motion.half_cos - v.y() * motion.half_sin, v.x() * motion.half_sin + v.y() * motion.half_cos};
  }
  bool is_near_core(const PlanarPiece& piece) const;
  /// Is all ground known that other chords of the same arc may come to? A straight stretch, in post coordinates.
  bool is_known_beside(const Vec2& from, const Vec2& to) const;
  BandPiece band_over(const Chord& chord, const GroundSpan& span) const;
  void close_cores(const Chord& chord, const GroundSpan& span, BandPiece& band) const;

  struct Core {
    Vec2 center;
    double reach_m = 0;
    double top_m = 0;  ///< Of a cylinder, or the middle of a sphere.
    bool sphere = false;
  };

  const World& world_;
  const HeightRaster* raster_ = nullptr;
  const PeakGround* peaks_ = nullptr;
  double radius_m_ = 0;
  SlopeLimits slopes_;
  double most_chord_m_ = 0;
  double arc_margin_m_ = 0;
  double arc_margin_posts_ = 0;
  double clearance_m_ = 0;
  double ceiling_agl_m_ = std::numeric_limits<double>::infinity();
  double ceiling_amsl_m_ = std::numeric_limits<double>::infinity();
  double peak_slope_ = 0;
  std::vector<Core> cores_;
};

inline BandPiece BandWalk::band_over(const Chord& chord, const GroundSpan& span) const {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  BandPiece band{.length_m = chord.length_m * (span.t_to - span.t_from),
                 .floor_from = -kOpen,
                 .floor_to = -kOpen,
                 .ceiling_from = ceiling_amsl_m_,
                 .ceiling_to = ceiling_amsl_m_};
  if (raster_ != nullptr || peaks_ != nullptr) {
    const double margin = chord.is_arc ? arc_margin_m_ : 0;
    const double up = std::max(0.0, span.bulge) + margin + clearance_m_;
    const double both = peaks_ != nullptr ? std::max(0.0, span.bulge) : std::max(0.0, -span.bulge);
    band.floor_from = span.from + up;
    band.floor_to = span.to + up;
    band.ceiling_from = std::min(band.ceiling_from, span.from + ceiling_agl_m_ - both - margin);
    band.ceiling_to = std::min(band.ceiling_to, span.to + ceiling_agl_m_ - both - margin);
  }
  if (chord.near_core) close_cores(chord, span, band);
  return band;
}

template <class Visit>
bool BandWalk::follow_raster(const Chord& chord, const Visit& visit) const {
  const HeightRaster& raster = *raster_;
  Vec2 from = raster.map(chord.from);
  if (!raster.covers(from)) return false;
  for (double t = 0; t < 1;) {
    const double t_to = raster.map.straight_until(chord.from, chord.to, t);
    const Vec2 to = raster.map(t_to < 1 ? Vec2(chord.from + t_to * (chord.to - chord.from)) : chord.to);
    if (!raster.covers(to) || (chord.is_arc && !is_known_beside(from, to))) return false;
    CellWalk walk({.from = from, .to = to}, raster.columns - 1, raster.rows - 1);
    for (bool inside = true; inside;) {
      const CellWalk::Exit exit = walk.exit(0);
      const float* upper = raster.posts.data() + static_cast<std::ptrdiff_t>(walk.row) * raster.columns + walk.column;
      const float* lower = upper + raster.columns;
      const auto h = double{upper[0]};
      const double b = double{upper[1]} - h;
      const double c = double{lower[0]} - h;
      const double d = double{lower[1]} - double{lower[0]} - b;
      const double u = walk.x + walk.dx * walk.t - walk.column;
      const double v = walk.y + walk.dy * walk.t - walk.row;
      const double part = exit.t - walk.t;
      const double slope = walk.dx * (b + v * d) + walk.dy * (c + u * d);
      const double curve = walk.dx * walk.dy * d * part * part;
      if (std::isnan(curve)) return false;
      const double first = h + u * b + v * (c + u * d);
      const GroundSpan span{.t_from = t + (t_to - t) * walk.t,
                            .t_to = t + (t_to - t) * exit.t,
                            .from = first,
                            .to = first + slope * part + curve,
                            .bulge = -0.25 * curve};
      if (span.t_to > span.t_from && !visit(band_over(chord, span))) return false;
      inside = walk.step(exit);
    }
    from = to;
    t = t_to;
  }
  return true;
}

template <class Visit>
bool BandWalk::follow_smooth(const Chord& chord, const Visit& visit) const {
  constexpr double kPiece_m = 4;
  const int count = std::max(1, static_cast<int>(std::ceil(chord.length_m / kPiece_m)));
  const double beside_m = chord.is_arc ? 2 * kSagitta_m : 0;
  const auto on_ground = [&](const Vec2& at) {
    return peaks_->area.contains(at - Vec2::Constant(beside_m)) && peaks_->area.contains(at + Vec2::Constant(beside_m));
  };
  for (int k = 0; k < count; ++k) {
    GroundSpan span{.t_from = static_cast<double>(k) / count, .t_to = static_cast<double>(k + 1) / count};
    if (peaks_ != nullptr) {
      const auto place = [&](double t) { return Vec2(chord.from + t * (chord.to - chord.from)); };
      if (!on_ground(place(span.t_from)) || !on_ground(place(span.t_to))) return false;
      span.from = peaks_->height(place(span.t_from));
      span.to = peaks_->height(place(span.t_to));
      span.bulge = std::max(0.0, peak_slope_ * chord.length_m / count - std::abs(span.to - span.from)) / 2;
    }
    if (!visit(band_over(chord, span))) return false;
  }
  return true;
}

}  // namespace alate
