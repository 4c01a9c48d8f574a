// Flights over real ground as ants see them: from every pose the primitives of the interval search, and now and then
// the shortest way to the goal, whole.
//
// Choices are looked at in single precision and without walking over the ground: what a primitive costs, and what is
// left from a point straight ahead of where it ends, as the climb field says. Seen from there and not from the end, so
// that the guide, which knows nothing of headings, tells a turn towards the goal from one away from it. The primitive
// that an ant is about to fly is then walked, label and cost exact.
//
// Trails lie on moves: on the bin of place and heading where a move begins, and the primitive.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "search/interval/interval_astar.hpp"
#include "space/choices.hpp"

namespace alate {

/// Where an ant is, with every altitude that it may have there.
struct FlightNode {
  enum class Phase : unsigned char { chooses_heading, flies, arrived };

  PlanarPose pose;
  AltitudeLabel label;
  double cost = 0;               ///< Of the move that led here; infinite if it may not be flown.
  std::uint32_t until_shot = 0;  ///< Moves until the shortest way to the goal is tried.
  Phase phase = Phase::chooses_heading;
  Eigen::Vector3f move;  ///< Name of the move that led here.
};

/// A flight of any pieces that is known already. Its moves can be told as actions, so that ants can follow it and its
/// moves can carry trails.
struct LearntFlight {
  Track pieces;
  FlightEnd end;
};

struct FlightAntsOptions {
  double bin_m = 100;    ///< Of trails; straight primitives are one and three of them long.
  double ahead_m = 300;  ///< How far ahead of a move its guide looks.
  std::size_t step_limit = 4000;
};

/// From where to where.
struct FlightEnds {
  FlightStart start;
  FlightEnd end;
};

/// Actions from 0: poses to start in, primitives, the shot. From `kKnown` on: pieces of known flights.
class FlightAnts {
 public:
  using State = FlightNode;

  /// `cost` and `to_go` must outlive this. At most as many poses as there are lanes in Choices.
  FlightAnts(const FlightCost& cost, const ClimbField& to_go, FlightEnds ends, const FlightAntsOptions& options);

  State start() const { return {.pose = {}, .label = start_.label, .move = Eigen::Vector3f::Zero()}; }
  std::size_t actions() const { return std::max(kShot + 1, start_.poses.size()); }
  std::size_t step_limit() const { return options_.step_limit; }

  void look(const State& state, Choices& out) const;
  State next(const State& state, std::size_t action) const;
  static bool is_free(const State& /*from*/, const State& to) { return to.cost < kInfinity; }
  static bool is_goal(const State& state) { return state.phase == State::Phase::arrived; }
  /// Where a state is, as trails know places: the move that led there.
  static Eigen::Vector3f place(const State& state) { return state.move; }

  /// Length and exposure of every move; ascent counts with the last one.
  std::optional<FlownActions> fly(std::span<const std::uint32_t> actions) const;

  /// The ground track of actions, a piece each but for the shot.
  Track track(std::span<const std::uint32_t> actions) const;
  const FlightEnd& end() const { return end_; }
  double start_m() const { return start_.label.low; }

  /// Takes a flight in, beside the one that is kept and in place of any other, and tells it as actions. Not while ants
  /// walk.
  std::vector<std::uint32_t> learn(const Track& track, const FlightEnd& end);
  /// Keeps the flight learnt last, which ants may follow from now on, in place of the one kept before.
  void keep_learnt() { kept_ ^= 1U; }
  static bool is_known(std::uint32_t action) { return action >= kKnown; }

 private:
  static constexpr std::size_t kPrimitives = 6;
  static constexpr std::size_t kShot = kPrimitives;
  static constexpr std::uint32_t kKnown = 64;

  /// One of the primitives, seen from where it begins.
  struct Primitive {
    Steering steering = Steering::straight;
    double length_m = 0;
    PlanarMotion motion;
  };
  /// Way to the goal from a pose.
  struct Shot {
    Track track;
    AltitudeLabel label;
    double cost = kInfinity;  ///< Ascent of the whole flight included.
  };

  void look_at_start(Choices& out) const;
  void look_at(const State& state, std::size_t k, bool near_threat, Choices& out) const;
  Shot shot(const State& state) const;
  double guide(const Vec2& at, const AltitudeLabel& label) const;
  bool is_near_threat(const Vec2& at) const;
  std::uint32_t moves_until_shot(const PlanarPose& pose) const;
  /// Price of the ascent that leads into an end; infinite if the label does not.
  double arrival(const AltitudeLabel& label, const FlightEnd& end) const;
  Eigen::Vector3f move_name(const PlanarPose& from, std::size_t action) const;
  std::size_t primitive_like(const PlanarPiece& piece) const;
  void fly_piece(const PlanarPiece& piece, State& state) const;
  void fly_known(std::size_t index, State& state) const;
  const PlanarPiece& known_piece(std::size_t index) const { return known_[index % 2].pieces[index / 2]; }

  const FlightCost& cost_;
  const ClimbField& to_go_;
  FlightStart start_;
  FlightEnd end_;
  FlightAntsOptions options_;
  double threat_weight_;
  std::array<Primitive, kPrimitives> primitives_{};
  std::array<LearntFlight, 2> known_;  ///< Ants may follow the one while the other is learnt.
  std::size_t kept_ = 0;
};

/// The same track, pieces that go on as the one before joined with it; arcs to three quarters of a circle.
Track joined(const Track& track);

}  // namespace alate
