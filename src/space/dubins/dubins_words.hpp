// Lengths of the six words of Dubins 1957, without branches: the core of single and batch kernels.
//
// Circles rather than the angles of Shkel, Lumelsky 2001: with u the vector between the centres of the first and the
// last circle, LSL is |u| + the change of heading, plus a full turn unless u points between the two headings, so it
// takes no inverse trigonometry; LSR and RSL take one arctangent each, LRL and RLR one arcsine. A word that begins to
// the right is the mirror image of one that begins to the left.
//
// Rounding must not cost a full turn. Where the first or last turn of a word comes out below zero, it counts as zero,
// not as nearly 2 pi, if this moves the end by no more than `slack`: with a turn too long by d the rest of the way is
// rotated about the centre of its circle by d, so the end moves by |u| d. Likewise a straight piece between circles
// that overlap by at most `slack` is there, of no length.
#pragma once

#include <cmath>
#include <limits>

#include "space/dubins/arctangent.hpp"
#include "space/dubins/planar_pose.hpp"

namespace alate::dubins {

/// The goal seen from the start, which lies at the origin and heads along +x; lengths in radii.
struct Goal {
  double x;
  double y;
  double cos;  ///< Of its heading.
  double sin;
  double turn;   ///< Its heading in [0, 2 pi].
  double slack;  ///< What the end may be off.
};

/// Ends may be off by 1e-10 radii, and by what the rounding of the coordinates that were given amounts to.
inline constexpr double kSlack = 1e-10;
inline constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

/// A goal, or a start, in the plane: what a loop over arrays has in hand.
struct View {
  double x, y, heading, cos, sin;
};

[[gnu::always_inline]] inline View view(const PlanarPose& pose) {
  return {pose.x, pose.y, pose.heading, pose.cos, pose.sin};
}

[[gnu::always_inline]] inline Goal goal_from(const View& from, const View& to, double per_radius) {
  const double east = (to.x - from.x) * per_radius;
  const double north = (to.y - from.y) * per_radius;
  const double size = (std::abs(from.x) + std::abs(to.x)) + (std::abs(from.y) + std::abs(to.y));
  const double change = to.heading - from.heading;
  const double left = change < 0 ? change + 2 * kPi : change;
  return {.x = east * from.cos + north * from.sin,
          .y = north * from.cos - east * from.sin,
          .cos = to.cos * from.cos + to.sin * from.sin,
          .sin = to.sin * from.cos - to.cos * from.sin,
          .turn = left < 2 * kPi ? left : left - 2 * kPi,
          .slack = kSlack + kRounding * (size * per_radius)};
}

[[gnu::always_inline]] inline Goal mirrored(const Goal& goal) {
  return {
      .x = goal.x, .y = -goal.y, .cos = goal.cos, .sin = -goal.sin, .turn = 2 * kPi - goal.turn, .slack = goal.slack};
}

struct Vector {
  double x, y;
};

/// A left turn from +x to another direction.
struct Sector {
  double angle;  ///< In [0, 2 pi].
  double cos, sin;
};

[[gnu::always_inline]] inline double lesser(double a, double b) { return b < a ? b : a; }

/// Does `v` point into the sector, or past a side of it by no more than `slack` at its tip? Below half a circle the
/// sector is where two half-planes meet, and on the side of its bisector: with slack, the half-planes of a narrow
/// sector also meet behind.
[[gnu::always_inline]] inline bool points_into(const Vector& v, const Sector& sector, double slack) {
  const double after_first = v.y + slack;
  const double before_last = v.x * sector.sin - v.y * sector.cos + slack;
  const double ahead = v.x * (1 + sector.cos) + v.y * sector.sin + 2 * slack;
  const double in_narrow = lesser(lesser(after_first, before_last), ahead);
  const double in_wide = after_first < before_last ? before_last : after_first;
  return (sector.angle <= kPi ? in_narrow : in_wide) >= 0;
}

/// Between the left circles of start and goal.
[[gnu::always_inline]] inline Vector left_to_left(const Goal& goal) {
  return {goal.x - goal.sin, goal.y + (goal.cos - 1)};
}

/// From the left circle of the start to the right one of the goal.
[[gnu::always_inline]] inline Vector left_to_right(const Goal& goal) {
  return {goal.x + goal.sin, goal.y - (goal.cos + 1)};
}

[[gnu::always_inline]] inline double squared(const Vector& v) { return v.x * v.x + v.y * v.y; }

[[gnu::always_inline]] inline double lsl_length(const Goal& goal) {
  const Vector u = left_to_left(goal);
  const bool direct = points_into(u, {goal.turn, goal.cos, goal.sin}, goal.slack);
  return std::sqrt(squared(u)) + (direct ? goal.turn : goal.turn + 2 * kPi);
}

/// The straight piece of LSR touches the circles crosswise.
struct Crossing {
  bool exists;
  double straight;
  double first_turn;  ///< Down to -slack / |u|.
  double last_turn;   ///< To the right; likewise.
};

[[gnu::always_inline]] inline Crossing lsr(const Goal& goal) {
  const Vector u = left_to_right(goal);
  const double square = squared(u);
  const double beyond = square - 4;
  const double p = std::sqrt(beyond > 0 ? beyond : 0.0);
  const double distance = std::sqrt(square);
  const double angle = arctangent(2 * u.x + u.y * p, u.x * p - 2 * u.y);
  const double first = angle * distance < -goal.slack ? angle + 2 * kPi : angle;
  const double last = first - goal.turn;
  return {.exists = beyond >= -4 * goal.slack,
          .straight = p,
          .first_turn = first,
          .last_turn = last * distance < -goal.slack ? last + 2 * kPi : last};
}

[[gnu::always_inline]] inline double lsr_length(const Goal& goal) {
  const Crossing way = lsr(goal);
  const double length = way.straight + (way.first_turn + way.last_turn);
  return way.exists ? length : std::numeric_limits<double>::infinity();
}

/// The middle circle of LRL touches both left circles; its long arc is the one that can be shortest.
struct Between {
  bool exists;
  double middle;      ///< In [pi, 2 pi].
  Vector first_turn;  ///< Heading after the first turn, as long as u.
  Sector outer;       ///< First and last turn together, a full turn less where not `direct`.
  bool direct;
};

[[gnu::always_inline]] inline Between lrl(const Goal& goal) {
  const Vector u = left_to_left(goal);
  const double square = squared(u);
  // sin(a) = |u| / 4, with 2 a what the long arc lacks of a circle.
  const double sine = std::sqrt(square) / 4;
  const double rest = 1 - square / 16;
  const double cosine = std::sqrt(rest > 0 ? rest : 0.0);
  const double lack = 2 * arctangent(sine, cosine);
  const double lack_cos = 1 - square / 8;
  const double lack_sin = 2 * sine * cosine;
  const double outer = goal.turn - lack;
  const Vector heading{-(u.x * cosine + u.y * sine), u.x * sine - u.y * cosine};
  const Sector sector{.angle = outer < 0 ? outer + 2 * kPi : outer,
                      .cos = goal.cos * lack_cos + goal.sin * lack_sin,
                      .sin = goal.sin * lack_cos - goal.cos * lack_sin};
  return {.exists = square < 16,
          .middle = 2 * kPi - lack,
          .first_turn = heading,
          .outer = sector,
          .direct = points_into(heading, sector, goal.slack)};
}

[[gnu::always_inline]] inline double lrl_length(const Goal& goal) {
  const Between way = lrl(goal);
  const double length = way.middle + (way.direct ? way.outer.angle : way.outer.angle + 2 * kPi);
  return way.exists ? length : std::numeric_limits<double>::infinity();
}

/// Three arcs are shortest only where circles of start and goal on one side are less than four radii apart, so never
/// beyond six radii; what comes of them there is infinite anyway.
[[gnu::always_inline]] inline bool may_curve(const Goal& goal) { return goal.x * goal.x + goal.y * goal.y < 36; }

/// Rounding must not make a path shorter than the straight line.
[[gnu::always_inline]] inline double not_below_straight(const Goal& goal, double length) {
  const double straight = std::sqrt(goal.x * goal.x + goal.y * goal.y);
  return straight > length ? straight : length;
}

/// The shortest word with a straight piece, in radii.
[[gnu::always_inline]] inline double shortest_with_straight(const Goal& goal) {
  const Goal mirror = mirrored(goal);
  return lesser(lesser(lsl_length(goal), lsl_length(mirror)), lesser(lsr_length(goal), lsr_length(mirror)));
}

/// The shortest of three arcs.
[[gnu::always_inline]] inline double shortest_of_arcs(const Goal& goal) {
  return lesser(lrl_length(goal), lrl_length(mirrored(goal)));
}

/// The shortest word.
[[gnu::always_inline]] inline double shortest_length(const Goal& goal) {
  return not_below_straight(goal, lesser(shortest_with_straight(goal), shortest_of_arcs(goal)));
}

}  // namespace alate::dubins
