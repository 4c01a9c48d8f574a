// Where the nodes of a terrain lattice lie, and how they are numbered.
//
// Source: Mai et al. 2023, section 2 (search space): equal steps along each axis, one plane of nodes for each step in
// the main direction. Departures: lengths are metres; the lattice begins in the start instead of a corner of the map,
// so the start is always a node; the goal need not be one: the last leg joins it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "alate/world/world.hpp"

namespace alate {

/// automatic: x or y, the longer side from start to goal; line: from start to goal, seen from above.
enum class MainDirection { automatic, x, y, line };

/// Metres; 0: see each.
struct LatticeSteps {
  MainDirection main = MainDirection::automatic;
  double main_m = 0;  ///< 0: a fiftieth of the way; rounded so that whole steps lead to the goal's plane.
  double side_m = 0;  ///< 0: side_share of main_m.
  double side_share = 1;
  double height_m = 0;  ///< 0: a fifth of main_m, but less where climb limits or the band ask for it.
  int window_side = 2;  ///< Cells that one move may shift sideways, and in height; 1 or 2.
  int window_height = 2;
};

/// Nodes of plane i (0: that of the start) lie at start + i main + side shift + height shift. The goal's plane has no
/// nodes. A move leads to the next plane; moves are numbered row by row, sideways shift first, from the most negative.
class LatticeFrame {
 public:
  using Node = std::uint32_t;
  static constexpr std::size_t kMostNodes = 600'000;
  static constexpr unsigned kMostMoves = 25;
  static constexpr unsigned kFirst = kMostMoves;  ///< In place of a last move, where there was none.

  /// What a move changes, in cells and in metres.
  struct Shift {
    int side = 0;
    int height = 0;
    Vec3 leg;
  };
  struct Place {
    int plane = 0;
    int side = 0;    ///< Column in the plane, from 0.
    int height = 0;  ///< Level, from 0.
  };

  /// The site must have ground.
  LatticeFrame(const World& world, const LatticeSteps& steps);

  /// Why there is no lattice; empty if there is one.
  const std::string& fault() const { return fault_; }

  int planes() const { return planes_; }  ///< Legs of every route.
  int columns() const { return columns_; }
  int levels() const { return levels_; }
  Node nodes() const { return static_cast<Node>(planes_) * plane_size(); }
  Node plane_size() const { return static_cast<Node>(columns_) * static_cast<Node>(levels_); }
  const std::vector<Shift>& shifts() const { return shifts_; }
  unsigned moves() const { return static_cast<unsigned>(shifts_.size()); }

  Node start() const { return node({0, -first_column_, -first_level_}); }
  Node node(const Place& at) const {
    return (static_cast<Node>(at.plane) * static_cast<Node>(columns_) + static_cast<Node>(at.side)) *
               static_cast<Node>(levels_) +
           static_cast<Node>(at.height);
  }
  Place place(Node node) const;
  /// The node a move leads to; only where it stays in the lattice.
  Node after(Node node, unsigned move) const { return node + static_cast<Node>(offsets_[move]); }
  bool stays(const Place& at, unsigned move) const;
  /// The move that shifts so many cells; nothing beyond the window.
  std::optional<unsigned> move(int side, int height) const;
  Vec3 position(const Place& at) const;
  Vec3 position(Node node) const { return position(place(node)); }
  /// Height of the ground at a node; NaN where there is none or it is unknown.
  double ground(const Place& at) const {
    const int cell = at.plane * columns_ + at.side;
    return ground_[static_cast<std::size_t>(cell)];
  }
  /// Step lengths along the main direction, sideways, upwards.
  const Vec3& steps_m() const { return steps_m_; }
  /// A vector by main direction, sideways, upwards.
  Vec3 along(const Vec3& vector) const { return {vector.dot(ahead_), vector.dot(aside_), vector.z()}; }
  const Vec3& goal() const { return goal_; }
  /// Does the window allow the last leg, from a node of the last plane to the goal?
  bool goal_in_window(const Vec3& from) const;
  /// Where the plane lies: "x 1200 m", "1200 m along the straight line".
  std::string plane_name(int plane) const;

 private:
  bool find_directions(MainDirection asked);
  void lay_planes(const LatticeSteps& steps);
  void lay_columns(const World& world);
  void lay_levels(const World& world, const LatticeSteps& steps);
  void note_moves(const LatticeSteps& steps);
  bool is_too_large(double columns, double levels);

  Vec3 start_;
  Vec3 goal_;
  MainDirection main_ = MainDirection::x;  ///< Not automatic.
  Vec3 ahead_ = Vec3::UnitX();             ///< Towards the goal, level.
  Vec3 aside_ = Vec3::UnitY();
  int planes_ = 0;
  int columns_ = 0;
  int levels_ = 0;
  int first_column_ = 0;  ///< Cells from the start.
  int first_level_ = 0;
  int window_side_ = 0;
  int window_height_ = 0;
  Vec3 steps_m_ = Vec3::Zero();  ///< Main, side, height.
  std::vector<Shift> shifts_;
  std::vector<std::int32_t> offsets_;
  std::vector<double> ground_;
  std::string fault_;
};

}  // namespace alate
