// A deposit of one's own: docs/write-your-own-planner.md, step 1.
#pragma once

#include "aco/deposit/ant_system.hpp"

// [policy]
/// Elitist Ant System: every ant that arrived leaves Q / L on its moves, and the best route so far gets `elitists`
/// times as much again. Source: Dorigo, Maniezzo, Colorni 1996, elitist strategy.
struct Elitist {
  double q = 1;
  double elitists = 8;

  template <class Trail>
  void operator()(Trail& trail, const alate::Harvest& harvest) const {
    alate::AntSystem{.q = q}(trail, harvest);
    if (!harvest.best.arrived()) return;
    for (const alate::TrailKey move : harvest.best.keys) trail.add(move, elitists * q / harvest.best.cost);
  }
};
// [/policy]
