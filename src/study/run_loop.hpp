// The loop of every comparison: many runs of planners, one thread each.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

#include "alate/check/check.hpp"
#include "alate/plan/planner.hpp"

namespace alate {

struct StudyRun {
  std::uint64_t seed = 0;
  Plan plan;
  Metrics metrics;
  bool passed = false;  ///< There is a route and nothing is wrong with it.
  double wall_s = 0;    ///< Planning alone.
};

/// Plans with one thread, measures and checks.
StudyRun run_once(const Planner& planner, const Problem& problem, RunOptions options);

struct RunLoop {
  std::size_t count = 0;
  std::function<void(std::size_t)> run;  ///< Called for each index below `count` that is handed out, by any thread.
  std::function<std::size_t()> next;  ///< Hands out 0, 1, 2, ... to all who share the work; empty: to this loop alone.
  std::stop_token stop;
  std::function<void(const Progress&)> on_progress;  ///< Called by one thread at a time; an iteration is a run.
};

/// False if it was stopped before the end.
bool run_all(const RunLoop& loop, Executor& executor);

}  // namespace alate
