// Which moves of a terrain lattice may be flown, worked out once, before any ant sets out.
//
// Every leg keeps the scenario's band, cores and area from end to end (World), and the aircraft's climb, descent and
// turning radius. On top come the constraints of Mai et al. 2023, eqs. (2)-(6), and the safety S of eq. (11).
// Departures: the paper tells neither whether S asks of the node or of the whole leg, nor how a constraint acts; both
// are options. One exact clearance serves all levels of a column: raised by a level, a leg clears as much more.
#pragma once

#include <array>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/candidates.hpp"
#include "space/lattice_frame.hpp"
#include "space/straight_limits.hpp"

namespace alate {

/// Constraints (1) to (5). (1), (2), (5) reconstructed, (3) verbatim, (4) partly read; no value is the paper's.
struct LatticeLimits {
  double length_m = kInfinity;       ///< (1), eq. (2): most of the route.
  double leg_m = 0;                  ///< (2), eq. (3): least of a leg.
  double height_agl_m = 0;           ///< (3), eq. (4): h_min of a node, above ground.
  double height_amsl_m = kInfinity;  ///< (3), eq. (4): h_max of a node.
  double pitch_rad = kPi / 2;        ///< (4), eq. (5): either way.
  double turn_rad = kPi;             ///< (5), eq. (6): seen from above.
};

struct LatticeRules {
  LatticeLimits limits;
  bool filters = true;     ///< Moves beyond the limits are no candidates; or they are, and are counted.
  double safe_agl_m = 0;   ///< h_s of eq. (11).
  bool whole_legs = true;  ///< S asks that the leg be free, not only its end.
  bool any_join = false;   ///< The last leg need not keep to the window.
  bool prunes = true;      ///< Moves that lead to dead ends only are no candidates.
};

/// How often each constraint is broken or takes a candidate away.
struct LatticeFaults {
  std::uint64_t length = 0, leg = 0, height = 0, pitch = 0, turn = 0;
  std::uint64_t collision = 0;  ///< Legs that are not free, between free nodes.

  std::uint64_t of_constraints() const { return length + leg + height + pitch + turn; }
  LatticeFaults& operator+=(const LatticeFaults& other);
};

/// Bit m of a set of moves: move m; bit kFirst: none yet.
class LatticeMoves {
 public:
  using Node = LatticeFrame::Node;
  using Place = LatticeFrame::Place;

  /// Stops early where `run` says so. `frame` must outlive this.
  LatticeMoves(const World& world, const LatticeFrame& frame, const LatticeRules& rules, RunContext& run);

  const LatticeRules& rules() const { return rules_; }
  bool stopped() const { return stopped_; }
  /// Does some string of moves lead to the goal, whatever the turns between them?
  bool has_way() const { return has_way_; }
  /// The last plane that moves from the start reach.
  int last_plane() const { return last_plane_; }

  unsigned open(Node node) const { return open_[node]; }
  /// Of the open moves those whose whole leg is free.
  unsigned clear(Node node) const { return clear_[node]; }
  /// Moves that may follow a move.
  unsigned follows(unsigned came) const { return follows_[came]; }
  /// Does what may follow depend on the move before?
  bool minds_turns() const { return aircraft_.minds_turns() || (rules_.filters && rules_.limits.turn_rad < kPi); }
  /// In the last plane: moves after which the last leg may follow.
  unsigned joins(Node node) const { return joins_[node - first_of_last_]; }
  bool is_reached(Node node) const { return reached_[node] != 0; }

  /// Faults of a move by itself and after another one, and of a node; where the rules filter, none is open.
  bool is_short(const Vec3& leg) const;
  bool is_steep(const Vec3& leg) const;
  bool is_sharp(const Vec3& before, const Vec3& after) const;
  bool is_high_or_low(const Place& at) const;

  /// What constraints took away: moves of reached nodes (leg, pitch), nodes (height), pairs of moves (turn).
  const LatticeFaults& barred() const { return barred_; }

 private:
  /// One move from one column of a plane.
  struct ColumnMove {
    int plane = 0;
    int column = 0;
    unsigned move = 0;
    unsigned lowest = 0;  ///< The lowest level whose leg clears the ground.
  };

  void note_shapes();
  bool flood(RunContext& run);
  void open_column(int plane, int column);
  void open_move(const ColumnMove& what);
  void note_joins(const RunContext& run);
  unsigned joins_from(Node node) const;
  void find_dead_ends();
  void count_barred();
  bool is_safe(const Place& at) const;
  bool is_free(const ColumnMove& what, int level) const;

  const World& world_;
  const LatticeFrame& frame_;
  LatticeRules rules_;
  StraightLimits aircraft_;
  bool asks_each_leg_;  ///< Ceilings above ground and cores do not simply rise with the level.
  double slack_m_;
  unsigned shapes_ = 0;
  std::array<unsigned, LatticeFrame::kMostMoves + 1> follows_{};
  std::vector<std::uint32_t> open_, clear_, joins_;
  std::vector<std::uint8_t> reached_;
  Node first_of_last_ = 0;
  int last_plane_ = 0;
  bool stopped_ = false;
  bool has_way_ = false;
  LatticeFaults barred_;
};

}  // namespace alate
