// Which altitudes an aircraft can have on a given ground track, and how much ascent each has cost it.
//
// Along a track the altitudes that can be reached from one altitude are an interval, whatever floor and ceiling do:
// every metre it widens by the slopes of climb and descent and is cut by floor and ceiling. The least ascent that leads
// to altitude z is `ascent + max(0, z - free)`: descending is free, and only what floors force counts before. So four
// numbers tell of every altitude profile at once, exactly where floor and ceiling are straight between knots.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace alate {

/// Greatest rise over planar length, both positive; may be infinite.
struct SlopeLimits {
  double climb = 0;
  double descent = 0;

  /// Of the same track flown the other way.
  SlopeLimits reversed() const { return {descent, climb}; }
};

/// Bounds that rounding keeps apart by no more touch: a goal just within reach, seen from both ends, and a floor as
/// steep as the climb come out to 1e-11 m either way. Floor and ceiling stay hard, the slope gives way.
inline constexpr double kTouch_m = 1e-9;

/// Cuts [low, high] to a band; leaves low > high where they are apart.
inline void cut_to(double floor, double ceiling, double& low, double& high) {
  const double before = low;
  low = std::max(low, floor);
  high = std::min(high, ceiling);
  if (low > high && low <= high + kTouch_m && floor <= ceiling) low = high = std::clamp(before, floor, ceiling);
}

/// Altitudes in metres; dead where low > high.
struct AltitudeLabel {
  double low = 0;
  double high = 0;
  double ascent = 0;  ///< Metres climbed so far by whoever is not above `free`.
  double free = 0;    ///< The highest altitude that costs no more than `ascent`; in [low, high].

  static AltitudeLabel at(double z) { return {z, z, 0, z}; }
  bool alive() const { return low <= high; }
  bool contains(const AltitudeLabel& other) const { return low <= other.low && high >= other.high; }
  /// Least ascent on the way to `z`, which must be in [low, high].
  double ascent_to(double z) const { return ascent + std::max(0.0, z - free); }

  /// At a knot: not below `floor`, not above `ceiling`.
  void clip(double floor, double ceiling) {
    cut_to(floor, ceiling, low, high);
    ascent += std::max(0.0, low - free);
    free = std::min(std::max(free, low), high);
  }
  /// Along a piece on which nothing is in the way.
  void advance(double length_m, const SlopeLimits& slopes) {
    low -= length_m * slopes.descent;
    high += length_m * slopes.climb;
  }
};

/// Where one label from the start meets one from the goal, flown the other way.
struct Meeting {
  double ascent = 0;  ///< Of the whole flight, the least.
  double z = 0;       ///< An altitude at which it is attained.
};

/// A label of the reversed flight counts what is a descent there as ascent here: its own `ascent` is of the true
/// flight, from the altitude met to the goal (see `BackwardLabel`). Nothing where they share no altitude.
struct BackwardLabel {
  double low = 0;
  double high = 0;
  double ascent = 0;  ///< Metres to be climbed by whoever is not below `free`.
  double free = 0;    ///< The lowest altitude from which no more is to be climbed; in [low, high].

  bool alive() const { return low <= high; }
  double ascent_from(double z) const { return ascent + std::max(0.0, free - z); }

  void clip(double floor, double ceiling) {
    cut_to(floor, ceiling, low, high);
    ascent += std::max(0.0, free - high);
    free = std::min(std::max(free, low), high);
  }
  /// Backward along a piece.
  void advance(double length_m, const SlopeLimits& slopes) {
    low -= length_m * slopes.climb;
    high += length_m * slopes.descent;
  }
};

inline std::optional<Meeting> meet(const AltitudeLabel& from_start, const BackwardLabel& to_goal) {
  const double low = std::max(from_start.low, to_goal.low);
  const double shared_high = std::min(from_start.high, to_goal.high);
  if (!(low <= shared_high + kTouch_m)) return std::nullopt;
  const double high = std::max(low, shared_high);
  // The sum is convex and changes its slope at the two free altitudes only.
  const auto at = [&](double z) { return Meeting{from_start.ascent_to(z) + to_goal.ascent_from(z), z}; };
  const Meeting one = at(std::clamp(from_start.free, low, high));
  const Meeting two = at(std::clamp(to_goal.free, low, high));
  return two.ascent < one.ascent ? two : one;
}

}  // namespace alate
