// Sparse A* over correction points, as published and with the error kept.
//
// Source: Zhou et al. 2020, improved sparse A* of its problem 2: f = g + q3 h, g = q1 R + q2 S, R the length flown, S
// the sum of (a + b) * length * drift, h the straight line left. A leg corrects one error (a + b = 1), so that S is R
// times the drift: length again, not corrections. Departures and gaps:
// - Legs are straight, the problem being its first; limits by the corrected recursion.
// - Which drift counts is not said where they differ: that of the error that is corrected, on the last leg their mean.
// - As published open and closed lists keep one g a node, and with it one error; closed nodes stay closed. That loses
//   routes: a longer way to a point, with a smaller error there, may be the only one that leads on.
// - Corrected: a label for each (length, error) at a node that no expanded one dominates. Then a route is found if
// there
//   is one.
// Cost: labels x (neighbours + log labels).
#pragma once

#include "alate/core/run_context.hpp"
#include "space/point_string.hpp"

namespace alate {

struct SparseAstarOptions {
  double q1 = 0.3;  ///< Of R.
  double q2 = 0.2;  ///< Of S.
  double q3 = 0.5;  ///< Of h; more than q1: the route may be longer than need be.
  bool keep_errors = true;
};

struct SparseAstarResult {
  bool found = false;
  PointString points;
  bool exhausted = false;  ///< With errors kept, all labels expanded: there is no route.
  double bound_m = 0;      ///< With errors kept: no route is shorter.
  std::uint64_t expansions = 0;
  std::uint64_t candidates = 0;
};

/// Polls `run` every 1024 expansions; nothing is found if that ends the search.
SparseAstarResult sparse_astar(const CorrectionGraph& graph, const SparseAstarOptions& options, RunContext& run);

}  // namespace alate
