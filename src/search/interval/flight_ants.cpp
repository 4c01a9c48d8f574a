#include "search/interval/flight_ants.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "space/dubins/dubins_point.hpp"

namespace alate {

namespace {

constexpr int kHeadings = 16;
constexpr double kArc = kPi / 8;
constexpr double kLongestArc = 1.5 * kPi;

Vec2 turned(const Vec2& v, const PlanarMotion& motion) {
  return {v.x() * motion.half_cos - v.y() * motion.half_sin, v.x() * motion.half_sin + v.y() * motion.half_cos};
}

/// `piece` cut into equal parts of at most `most_m`.
void append_cut(Track& track, const PlanarPiece& piece, double most_m) {
  const int count = std::max(1, static_cast<int>(std::ceil(piece.length_m / most_m)));
  PlanarPiece part = piece;
  part.length_m = piece.length_m / count;
  for (int i = 0; i < count; ++i) {
    track.push_back(part);
    part.start = part.end();
  }
}

}  // namespace

Track joined(const Track& track) {
  Track joined;
  for (const PlanarPiece& piece : track) {
    const bool goes_on = !joined.empty() && joined.back().steering == piece.steering;
    const double length_m = goes_on ? joined.back().length_m + piece.length_m : 0;
    if (goes_on && (piece.steering == Steering::straight || length_m < kLongestArc * piece.radius_m))
      joined.back().length_m = length_m;
    else
      joined.push_back(piece);
  }
  return joined;
}

FlightAnts::FlightAnts(const FlightCost& cost, const ClimbField& to_go, FlightEnds ends,
                       const FlightAntsOptions& options)
    : cost_(cost),
      to_go_(to_go),
      start_(std::move(ends.start)),
      end_(std::move(ends.end)),
      options_(options),
      threat_weight_(cost.band().world().site().scenario.objective.threat) {
  assert(start_.poses.size() <= kLanes);
  using enum Steering;
  const double radius = cost.band().radius_m();
  const double arc = radius * kArc;
  const std::array<std::pair<Steering, double>, kPrimitives> all{{{left, arc},
                                                                  {right, arc},
                                                                  {left, 2 * arc},
                                                                  {right, 2 * arc},
                                                                  {straight, options.bin_m},
                                                                  {straight, 3 * options.bin_m}}};
  for (std::size_t k = 0; k < kPrimitives; ++k)
    primitives_[k] = {all[k].first, all[k].second, planar_motion(all[k].first, all[k].second, radius)};
}

void FlightAnts::look(const State& state, Choices& out) const {
  out.resize(actions());
  std::ranges::fill(out.cost, std::numeric_limits<float>::infinity());
  std::ranges::fill(out.guide, 0.0F);
  if (state.phase == State::Phase::chooses_heading) return look_at_start(out);
  const bool near_threat = is_near_threat(state.pose.position());
  for (std::size_t k = 0; k < kPrimitives; ++k) look_at(state, k, near_threat, out);
  if (state.until_shot == 0) out.cost[kShot] = static_cast<float>(shot(state).cost);
  for (std::size_t k = 0; k <= kShot; ++k) {
    const Eigen::Vector3f name = move_name(state.pose, k);
    out.x[k] = name.x();
    out.y[k] = name.y();
    out.z[k] = name.z();
  }
}

void FlightAnts::look_at_start(Choices& out) const {
  for (std::size_t k = 0; k < start_.poses.size(); ++k) {
    const PlanarPose& pose = start_.poses[k];
    const Eigen::Vector3f name = move_name(pose, 0);
    out.x[k] = name.x();
    out.y[k] = name.y();
    out.z[k] = name.z() - 1;
    out.cost[k] = 0;
    AltitudeLabel label = start_.label;
    label.advance(options_.ahead_m, cost_.band().slopes());
    const double rest = guide(pose.position() + options_.ahead_m * pose.direction(), label);
    out.guide[k] = static_cast<float>(std::isfinite(rest) ? rest : 0);
  }
}

/// A place ahead from which no way is seen counts as a detour as long as it is far.
void FlightAnts::look_at(const State& state, std::size_t k, bool near_threat, Choices& out) const {
  const Primitive& primitive = primitives_[k];
  const Vec2 from = state.pose.position();
  const Vec2 chord = turned(state.pose.direction(), primitive.motion);
  const Vec2 end = from + primitive.motion.chord_m * chord;
  const Vec2 ahead = end + options_.ahead_m * turned(chord, primitive.motion);
  AltitudeLabel label = state.label;
  label.advance(primitive.length_m, cost_.band().slopes());
  double cost = cost_.length_weight() * primitive.length_m;
  double rest = guide(end, label);
  if (!std::isfinite(rest)) return;
  double onward = cost_.length_weight() * options_.ahead_m;
  const double z = std::clamp(state.label.free, label.low, label.high);
  if (near_threat) {
    const World& world = cost_.band().world();
    cost += world.exposure({{from.x(), from.y(), z}, {end.x(), end.y(), z}}) * threat_weight_;
    onward += world.exposure({{end.x(), end.y(), z}, {ahead.x(), ahead.y(), z}}) * threat_weight_;
  }
  label.advance(options_.ahead_m, cost_.band().slopes());
  const double seen = guide(ahead, label);
  if (std::isfinite(seen)) rest = seen;
  out.cost[k] = static_cast<float>(cost);
  out.guide[k] = static_cast<float>(onward + rest);
}

/// Cost to the goal and of the ascent so far, at the best of three altitudes.
double FlightAnts::guide(const Vec2& at, const AltitudeLabel& label) const {
  const auto from = [&](double z) { return to_go_({at.x(), at.y(), z}) + cost_.climb_weight() * label.ascent_to(z); };
  return std::min({from(label.free), from(label.high), from(label.low)});
}

bool FlightAnts::is_near_threat(const Vec2& at) const {
  const double longest = std::max(primitives_[3].length_m, primitives_[5].length_m) + options_.ahead_m;
  return std::ranges::any_of(cost_.band().world().site().threats, [&](const Threat& threat) {
    const double reach = threat.radius_m + longest;
    return (threat.center.head<2>() - at).squaredNorm() < reach * reach;
  });
}

/// The farther the goal, the rarer, as in the search.
std::uint32_t FlightAnts::moves_until_shot(const PlanarPose& pose) const {
  const double distance = (end_.place() - pose.position()).norm();
  return static_cast<std::uint32_t>(std::clamp(distance / (20 * cost_.band().radius_m()), 0.0, 31.0));
}

double FlightAnts::arrival(const AltitudeLabel& label, const FlightEnd& end) const {
  const double low = std::max(label.low, end.low());
  const double high = std::min(label.high, end.high());
  if (!(low <= high)) return kInfinity;
  return cost_.climb_weight() * label.ascent_to(std::clamp(label.free, low, high));
}

FlightAnts::Shot FlightAnts::shot(const State& state) const {
  Shot shot{.track = {}, .label = state.label};
  append(shot.track, shortest_dubins_to_point(state.pose, end_.place(), cost_.band().radius_m()));
  cut_at_end(shot.track, end_);
  const double cost = cost_.advance(shot.track, shot.label);
  if (shot.label.alive()) shot.cost = cost + arrival(shot.label, end_);
  return shot;
}

Eigen::Vector3f FlightAnts::move_name(const PlanarPose& from, std::size_t action) const {
  constexpr int kActions = 8;
  const int heading = static_cast<int>(std::lround(from.heading / (2 * kPi) * kHeadings)) & (kHeadings - 1);
  const Vec2 bin = (from.position() - start_.poses[0].position()) / options_.bin_m;
  return {static_cast<float>(std::floor(bin.x() + 0.5)), static_cast<float>(std::floor(bin.y() + 0.5)),
          static_cast<float>(kActions * heading + static_cast<int>(action) + 1)};
}

std::size_t FlightAnts::primitive_like(const PlanarPiece& piece) const {
  if (piece.steering == Steering::straight) return piece.length_m < 2 * options_.bin_m ? 4 : 5;
  const std::size_t shorter = piece.length_m < 1.5 * kArc * piece.radius_m ? 0 : 2;
  return piece.steering == Steering::left ? shorter : shorter + 1;
}

void FlightAnts::fly_piece(const PlanarPiece& piece, State& state) const {
  state.cost = cost_.advance(piece, state.label);
  if (!state.label.alive()) state.cost = kInfinity;
  state.pose = piece.end();
  state.phase = State::Phase::flies;
}

void FlightAnts::fly_known(std::size_t index, State& state) const {
  const LearntFlight& flight = known_[index % 2];
  fly_piece(known_piece(index), state);
  if (index / 2 + 1 < flight.pieces.size() || !(state.cost < kInfinity)) return;
  state.cost += arrival(state.label, flight.end);
  state.phase = State::Phase::arrived;
}

FlightNode FlightAnts::next(const State& state, std::size_t action) const {
  State to = state;
  if (is_known(static_cast<std::uint32_t>(action))) {
    const std::size_t index = action - kKnown;
    to.move = move_name(known_piece(index).start, primitive_like(known_piece(index)));
    fly_known(index, to);
  } else if (state.phase == State::Phase::chooses_heading) {
    to.pose = start_.poses[action];
    to.move = move_name(to.pose, 0) - Eigen::Vector3f(0, 0, 1);
    to.cost = 0;
    to.phase = State::Phase::flies;
    return to;
  } else if (action == kShot) {
    const Shot last = shot(state);
    to = {.pose = last.track.empty() ? state.pose : last.track.back().end(),
          .label = last.label,
          .cost = last.cost,
          .phase = State::Phase::arrived,
          .move = move_name(state.pose, action)};
  } else {
    const Primitive& primitive = primitives_[action];
    to.move = move_name(state.pose, action);
    fly_piece({primitive.steering, state.pose, primitive.length_m, cost_.band().radius_m()}, to);
  }
  to.until_shot = state.until_shot > 0 ? state.until_shot - 1 : moves_until_shot(to.pose);
  return to;
}

std::optional<FlownActions> FlightAnts::fly(std::span<const std::uint32_t> actions) const {
  FlownActions flown;
  State state = start();
  for (const std::uint32_t action : actions) {
    state = next(state, action);
    if (!(state.cost < kInfinity)) return std::nullopt;
    flown.cost += state.cost;
    flown.costs.push_back(static_cast<float>(state.cost));
    ++flown.moves;
    if (is_goal(state)) return flown;
  }
  return std::nullopt;
}

Track FlightAnts::track(std::span<const std::uint32_t> actions) const {
  Track track;
  State state = start();
  for (const std::uint32_t action : actions) {
    if (is_known(action)) {
      track.push_back(known_piece(action - kKnown));
    } else if (state.phase == State::Phase::flies && action == kShot) {
      const Shot last = shot(state);
      track.insert(track.end(), last.track.begin(), last.track.end());
    } else if (state.phase == State::Phase::flies) {
      const Primitive& primitive = primitives_[action];
      track.push_back({primitive.steering, state.pose, primitive.length_m, cost_.band().radius_m()});
    }
    state = next(state, action);
  }
  return track;
}

std::vector<std::uint32_t> FlightAnts::learn(const Track& track, const FlightEnd& end) {
  const std::size_t slot = kept_ ^ 1U;
  LearntFlight& flight = known_[slot];
  flight = {.pieces = {}, .end = end};
  for (const PlanarPiece& piece : track)
    append_cut(flight.pieces, piece,
               piece.steering == Steering::straight ? primitives_[5].length_m : primitives_[3].length_m);
  std::vector<std::uint32_t> actions(flight.pieces.size());
  for (std::size_t i = 0; i < actions.size(); ++i) actions[i] = static_cast<std::uint32_t>(kKnown + 2 * i + slot);
  return actions;
}

}  // namespace alate
