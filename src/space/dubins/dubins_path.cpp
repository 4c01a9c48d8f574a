#include "space/dubins/dubins_path.hpp"

#include <algorithm>
#include <limits>

#include "space/dubins/dubins_words.hpp"

namespace alate {

namespace {

using dubins::Goal;
using Turns = std::array<double, 3>;

double positive(double angle) { return angle < 0 ? angle + 2 * kPi : angle; }

/// First turn in [0, whole] whose heading is `heading`; one that rounding has put outside goes to the nearer end.
double part_of(double whole, double heading) {
  const double turn = positive(heading);
  if (turn <= whole) return turn;
  return turn - whole < 2 * kPi - turn ? whole : 0.0;
}

Turns lsl_turns(const Goal& goal) {
  const dubins::Vector u = dubins::left_to_left(goal);
  const double straight = std::sqrt(dubins::squared(u));
  const bool direct = dubins::points_into(u, {goal.turn, goal.cos, goal.sin}, goal.slack);
  if (direct && straight <= goal.slack) return {goal.turn, 0, 0};
  const double heading = arctangent(u.y, u.x);
  if (!direct) return {positive(heading), straight, std::max(0.0, goal.turn + 2 * kPi - positive(heading))};
  const double first = part_of(goal.turn, heading);
  return {first, straight, goal.turn - first};
}

Turns lsr_turns(const Goal& goal) {
  const dubins::Crossing way = dubins::lsr(goal);
  return {std::max(0.0, way.first_turn), way.straight, std::max(0.0, way.last_turn)};
}

Turns lrl_turns(const Goal& goal) {
  const dubins::Between way = dubins::lrl(goal);
  const double heading = arctangent(way.first_turn.y, way.first_turn.x);
  if (!way.direct) return {positive(heading), way.middle, std::max(0.0, way.outer.angle + 2 * kPi - positive(heading))};
  const double first = part_of(way.outer.angle, heading);
  return {first, way.middle, way.outer.angle - first};
}

Turns turns_of(DubinsWord word, const Goal& goal) {
  switch (word) {
    case DubinsWord::lsl:
      return lsl_turns(goal);
    case DubinsWord::rsr:
      return lsl_turns(mirrored(goal));
    case DubinsWord::lsr:
      return lsr_turns(goal);
    case DubinsWord::rsl:
      return lsr_turns(mirrored(goal));
    case DubinsWord::lrl:
      return lrl_turns(goal);
    case DubinsWord::rlr:
      break;
  }
  return lrl_turns(mirrored(goal));
}

/// Length of each word, in the order of DubinsWord.
std::array<double, 6> word_lengths(const Goal& goal) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Goal mirror = mirrored(goal);
  std::array lengths{dubins::lsl_length(goal),
                     dubins::lsl_length(mirror),
                     dubins::lsr_length(goal),
                     dubins::lsr_length(mirror),
                     kNone,
                     kNone};
  if (dubins::may_curve(goal)) {
    lengths[4] = dubins::lrl_length(goal);
    lengths[5] = dubins::lrl_length(mirror);
  }
  return lengths;
}

}  // namespace

std::array<Steering, 3> steering_of(DubinsWord word) {
  using enum Steering;
  switch (word) {
    case DubinsWord::lsl:
      return {left, straight, left};
    case DubinsWord::rsr:
      return {right, straight, right};
    case DubinsWord::lsr:
      return {left, straight, right};
    case DubinsWord::rsl:
      return {right, straight, left};
    case DubinsWord::lrl:
      return {left, right, left};
    case DubinsWord::rlr:
      break;
  }
  return {right, left, right};
}

DubinsPath shortest_dubins(const PlanarPose& from, const PlanarPose& to, double radius_m) {
  const Goal goal = dubins::goal_from(dubins::view(from), dubins::view(to), 1 / radius_m);
  const std::array<double, 6> lengths = word_lengths(goal);
  const auto shortest = static_cast<std::size_t>(std::ranges::min_element(lengths) - lengths.begin());
  const auto word = static_cast<DubinsWord>(shortest);
  const Turns turns = turns_of(word, goal);
  return {.start = from,
          .radius_m = radius_m,
          .word = word,
          .lengths_m = {radius_m * turns[0], radius_m * turns[1], radius_m * turns[2]},
          .length_m = radius_m * dubins::not_below_straight(goal, lengths[shortest])};
}

double dubins_length(const PlanarPose& from, const PlanarPose& to, double radius_m) {
  const Goal goal = dubins::goal_from(dubins::view(from), dubins::view(to), 1 / radius_m);
  if (dubins::may_curve(goal)) return radius_m * dubins::shortest_length(goal);
  return radius_m * dubins::not_below_straight(goal, dubins::shortest_with_straight(goal));
}

}  // namespace alate
