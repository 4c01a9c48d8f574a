// A cost that no flight over real ground undercuts, because it must pass somewhere; and the proof that none exists.
//
// The plane is cut into square cells. A flight that crosses a side of a cell at altitude z costs at least the way from
// the start to the nearest place of the side, no shorter than the climb or descent to z needs, plus the same from there
// to the goal's ball, plus the price of both ascents; the least over the altitudes that are open on the side is the
// side's price. Every flight goes from cell to cell, so it costs at least the highest price on the way where that is
// least: a minimax path, by one search in Dijkstra's order that looks at cells and sides as it comes to them.
//
// Open altitudes are optimistic (`OpenAir`), headings and turns are left out; so if the goal is not reached, there is
// no flight.
#pragma once

#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"
#include "space/bound/open_air.hpp"

namespace alate {

struct Bottleneck {
  double cost = 0;              ///< Valid even if the search was stopped.
  bool barred = false;          ///< No flight exists, if `Voids` were as assumed.
  bool at_start = false;        ///< Barred since the start is not open.
  bool at_goal = false;         ///< Barred since nothing is open within the goal's tolerance.
  Vec2 nearest = Vec2::Zero();  ///< Middle of the cell nearest to the goal that can be reached.
};

struct BottleneckOptions {
  Voids voids = Voids::closed;
  double most_cells = 50'000;  ///< No finer than the raster: about 10 ms.
};

/// For the physical objective over ground. Stops early when `run` says so.
Bottleneck bottleneck(const Problem& problem, const BottleneckOptions& options, RunContext& run);

}  // namespace alate
