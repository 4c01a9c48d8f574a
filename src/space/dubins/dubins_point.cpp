#include "space/dubins/dubins_point.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "space/dubins/dubins_pieces.hpp"
#include "space/dubins/dubins_words.hpp"

namespace alate {

namespace {

using dubins::Vector;

/// The point seen from the start, which lies at the origin and heads along +x; lengths in radii.
struct Target {
  double x, y;
  double slack;  ///< As for poses (dubins_words.hpp).
};

struct Way {
  double first = std::numeric_limits<double>::infinity();
  double straight = 0;
  double last = 0;

  double length() const { return first + straight + last; }
};

double positive(double angle) { return angle < 0 ? angle + 2 * kPi : angle; }

/// Left, then straight. None into the circle.
Way left_straight(const Target& to) {
  const Vector u{to.x, to.y - 1};
  const double beyond = dubins::squared(u) - 1;
  if (beyond < -2 * to.slack) return {};
  const double straight = std::sqrt(std::max(0.0, beyond));
  const double angle = arctangent(u.x + u.y * straight, u.x * straight - u.y);
  const double off = std::sqrt(dubins::squared(u)) * angle;
  return {.first = off < 0 && off >= -to.slack ? 0.0 : positive(angle), .straight = straight};
}

/// Right, then left on a circle through the point: the second circle lies on either side of the line from the first one
/// to the point, as `side` says. None where the point is too near the first or too far away.
Way right_left(const Target& to, double side) {
  const Vector u{to.x, to.y + 1};
  const double distance = std::sqrt(dubins::squared(u));
  const double cosine = distance > 0 ? (distance * distance + 3) / (4 * distance) : 2;
  if (cosine > 1) return {};
  const double sine = side * std::sqrt(1 - cosine * cosine);
  const Vector center{2 * (u.x * cosine - u.y * sine) / distance, 2 * (u.x * sine + u.y * cosine) / distance};
  const double at = arctangent(center.y, center.x);
  const double leave = arctangent(u.y - center.y, u.x - center.x);
  return {.first = positive(kPi / 2 - at), .straight = 0, .last = positive(wrapped(leave - at - kPi))};
}

struct Choice {
  DubinsWord word = DubinsWord::lsl;
  Way way;
};

Choice shortest_way(const Target& to) {
  const Target mirror{to.x, -to.y, to.slack};
  Choice best{DubinsWord::lsl, left_straight(to)};
  for (const Choice& choice :
       {Choice{DubinsWord::rsr, left_straight(mirror)}, Choice{DubinsWord::rsl, right_left(to, 1)},
        Choice{DubinsWord::rsl, right_left(to, -1)}, Choice{DubinsWord::lsr, right_left(mirror, 1)},
        Choice{DubinsWord::lsr, right_left(mirror, -1)}}) {
    if (choice.way.length() < best.way.length()) best = choice;
  }
  return best;
}

/// The word flown the other way round.
DubinsWord reversed_word(DubinsWord word) {
  if (word == DubinsWord::lsl) return DubinsWord::rsr;
  return word == DubinsWord::rsr ? DubinsWord::lsl : word;
}

}  // namespace

DubinsPath shortest_dubins_to_point(const PlanarPose& from, const Vec2& to, double radius_m) {
  const dubins::Goal seen = dubins::goal_from(dubins::view(from), {to.x(), to.y(), 0, 1, 0}, 1 / radius_m);
  const auto [word, way] = shortest_way({seen.x, seen.y, seen.slack});
  const double straight_m = (to - from.position()).norm();
  return {.start = from,
          .radius_m = radius_m,
          .word = word,
          .lengths_m = {radius_m * way.first, radius_m * way.straight, radius_m * way.last},
          .length_m = std::max(straight_m, radius_m * way.length())};
}

DubinsPath shortest_dubins_from_point(const Vec2& from, const PlanarPose& to, double radius_m) {
  DubinsPath path = shortest_dubins_to_point(reversed(to), from, radius_m);
  path.start = reversed(pieces_of(path).back().end());
  path.start.x = from.x();
  path.start.y = from.y();
  path.word = reversed_word(path.word);
  std::ranges::reverse(path.lengths_m);
  return path;
}

}  // namespace alate
