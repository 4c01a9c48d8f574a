// Rank-based Ant System: the w - 1 best ants leave (w - r) Q / J_r, the best so far w Q / J_best.
//
// Source: Bullnheimer, Hartl, Strauss 1999, eqs. (3), (4). Equal costs rank by the index of the ant.
#pragma once

#include <algorithm>

#include "aco/ant.hpp"

namespace alate {

struct RankBased {
  double q = 50;
  std::size_t w = 6;

  template <class Trail>
  void operator()(Trail& trail, const Harvest& harvest) const {
    std::vector<const Ant*> ranked;
    for (const Ant& ant : harvest.ants)
      if (ant.arrived()) ranked.push_back(&ant);
    std::ranges::stable_sort(ranked, {}, &Ant::cost);
    for (std::size_t r = 1; r < w && r <= ranked.size(); ++r) leave(trail, *ranked[r - 1], static_cast<double>(w - r));
    if (harvest.best.arrived()) leave(trail, harvest.best, static_cast<double>(w));
  }

 private:
  template <class Trail>
  void leave(Trail& trail, const Ant& ant, double times) const {
    for (const TrailKey node : ant.keys) trail.add(node, times * q / ant.cost);
  }
};

}  // namespace alate
