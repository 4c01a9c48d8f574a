// One run of one planner, for tests.
#pragma once

#include "alate/plan/registry.hpp"
#include "support/hand_made_sites.hpp"

namespace alate::test {

inline Plan fly(const World& world, const PlannerRequest& request, RunOptions options = {}, int threads = 1) {
  const Problem problem(world);
  const ChosenPlanner chosen = choose_planner(builtin_planners(), problem, request);
  Executor executor(threads);
  RunContext run(executor, std::move(options));
  return chosen.planner.plan(problem, run);
}

inline Plan fly(const Site& site, const PlannerRequest& request, RunOptions options = {}, int threads = 1) {
  return fly(World(site), request, std::move(options), threads);
}

}  // namespace alate::test
