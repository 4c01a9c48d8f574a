// What is to be solved, and what came out.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/core/run_context.hpp"
#include "alate/world/world.hpp"

namespace alate {

enum class Outcome { optimal, feasible, infeasible_proven, none_found };

const char* to_string(Outcome outcome);

/// Which point of a front becomes the route.
enum class Preference { length, corrections, probability };

/// Borrowed view of what is to be solved.
struct Problem {
  const World& world;
  const Vehicle& vehicle;
  const Mission& mission;
  const ObjectiveSpec& objective;
  Preference prefer = Preference::length;
  bool front = false;  ///< The whole Pareto front is asked for, where a planner knows it.

  explicit Problem(const World& w) : Problem(w, w.site().mission) {}
  /// Between other ends than the site's; `m` must outlive this.
  Problem(const World& w, const Mission& m) : Problem(w, m, w.site().scenario.objective) {}
  /// And for other costs; so must `o`.
  Problem(const World& w, const Mission& m, const ObjectiveSpec& o)
      : world(w), vehicle(w.site().vehicle), mission(m), objective(o) {}
};

/// What a colony on a grid knows after an iteration.
struct GridStats {
  GridMeasures best;                 ///< Of the route with the best score so far, as the colony measures it.
  std::optional<double> mean_score;  ///< Of the ants that arrived in this iteration.
};

/// One iteration of a colony or a population. Costs are of the ants that arrived, of the individuals that are routes;
/// nothing where none did.
struct IterationStats {
  std::optional<double> best_so_far;
  std::optional<double> best;
  std::optional<double> mean;
  std::optional<double> worst;
  double arrived = 0;             ///< Share of them, 0 to 1.
  std::optional<double> known;    ///< Colonies: share of moves onto a trail that an earlier iteration had left, 0 to 1.
  std::optional<GridStats> grid;  ///< Colonies on grids, once an ant has arrived.
};

/// One route of a Pareto front of length, corrections and chance of success.
struct FrontPoint {
  double length_m = 0;
  int corrections = 0;
  double probability = 1;
  std::vector<int> points;  ///< Ids of the correction points in order, without start and goal.
};

/// What came out.
struct Plan {
  Outcome outcome = Outcome::none_found;
  Stop stop = Stop::finished;
  Route route;             ///< Empty unless optimal or feasible.
  double cost = 0;         ///< As the planner sums it; what counts is `measure`. Meaningless without a route.
  double lower_bound = 0;  ///< No route of this problem costs less. Always valid, 0 if nothing better is known.
  std::uint64_t seed = 0;
  bool reproducible = true;                       ///< False after a deadline or a cancel.
  std::map<std::string, std::uint64_t> counters;  ///< "candidates", "iterations", ...
  std::vector<IterationStats> history;            ///< Colonies and populations, one entry an iteration.
  std::vector<FrontPoint> front;                  ///< If asked for; by corrections, then length.
  std::string why;  ///< Without a route: what bars the way, and where; with one: what it is.
};

}  // namespace alate
