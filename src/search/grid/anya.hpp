// The shortest way at any angle.
#pragma once

#include <vector>

#include "alate/core/run_context.hpp"
#include "search/grid/bucket_queue.hpp"
#include "search/grid/cone.hpp"
#include "search/grid/corner_labels.hpp"
#include "search/grid/row_scan.hpp"

namespace alate {

/// A way at any angle, or none.
struct AnyAngleWay {
  bool found = false;
  bool finished = false;  ///< False after a stop: then it is not proven that there is no way, or no shorter one.
  std::vector<GridPoint> points;  ///< Start, corners of cells, goal; one point if start and goal are one.
  double length = 0;              ///< In cell sides.
  std::uint64_t expansions = 0;
};

/// Anya (Harabor, Grastien, Oez and Aksakalli 2016, Optimal any-angle pathfinding in practice): A* over cones, what a
/// point sees of a row. A shortest way turns at corners of blocked cells only, and there it bends round them; so a cone
/// is pushed on row by row, split where cells are blocked, and a new one begins at every corner that it passes.
/// Nothing is worked out beforehand but the bits.
///
/// The way may touch a corner or run along a side, but not slip between two blocked cells that share a corner.
///
/// Departures: ends are middles of cells; cones are bounded by rays instead of fractions; flat intervals are not kept
/// but run along at once to all corners they lead to; and the open list is one of buckets, so the search ends when no
/// open cone can lead to a shorter way. Of ways to a corner that differ by less than kTie the first stays.
///
/// Made once for a map and asked many times: a query clears and allocates nothing. Not for two threads at once.
class Anya {
 public:
  static constexpr double kTie = 1e-10;  ///< Cell sides.

  /// `grid` must outlive this.
  explicit Anya(const BitGrid& grid);

  /// Between free cells of the map.
  AnyAngleWay find(GridPlace start, GridPlace goal, RunContext& run);

 private:
  using Corner = CornerLabels::Corner;
  struct Entry {
    Cone cone;
    double least = 0;
  };
  /// One side of the way.
  enum class Side { left, right };

  static OctileCost priority(double length) { return static_cast<OctileCost>(length * static_cast<double>(kStraight)); }
  bool search(RunContext& run);
  void expand(const Cone& cone);
  void pass(const Cone& cone, FreeRun run, double left, double right);
  void enter(const Cone& cone, Rays rays, FreeRun run);
  void look_for_goal(const Cone& cone, Rays rays);
  bool turn(const Root& from, int x, int y, Root& root);
  void turn_inwards(const Cone& cone, FreeRun run, Side side, double ray);
  void turn_outwards(const Cone& cone, FreeRun run, Side side, double x);
  void run_along(const Root& from, const Cone& cone, Side side);
  void trace(AnyAngleWay& way) const;

  static constexpr Corner kStart = 0;  ///< No way turns at that corner of the rim.

  const BitGrid& grid_;
  CornerLabels labels_;
  BucketQueue<Entry> open_;
  GridPoint start_, goal_;
  int goal_row_ = 0;
  int goal_column_ = 0;
  double best_ = 0;  ///< Length of the shortest way known.
  Root last_;        ///< From where it leads straight to the goal.
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
