// Methods tried on cases over seeds.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "alate/check/check.hpp"
#include "alate/plan/registry.hpp"
#include "alate/study/reproduce.hpp"
#include "study/run_loop.hpp"
#include "study/statistics.hpp"

namespace alate {

struct StudyCase {
  std::string name;
  World world;

  const Site& site() const { return world.site(); }
};

struct StudyMethod {
  std::string name;
  std::string help;
  PlannerRequest request;
  std::optional<std::uint64_t> iterations;  ///< None: the planner's default.
  bool front = false;                       ///< Ask for the whole Pareto front.
  bool keep_routes = true;                  ///< False where there are many runs: measured, checked, and dropped.
};

/// All runs of one method on one case, by seed.
struct Trial {
  std::size_t case_index = 0;
  std::size_t method_index = 0;
  ChosenPlanner planner;
  std::vector<StudyRun> runs;

  /// Costs of the runs that passed.
  std::vector<double> costs() const;
  std::optional<Summary> summary() const { return summarize(costs()); }
  /// The cheapest run that passed, the first of equals; null if none did.
  const StudyRun* best() const;
};

struct Experiment {
  std::vector<StudyCase> cases;
  std::vector<StudyMethod> methods;
  std::vector<Trial> trials;  ///< Case by case, in the order of methods.

  const Trial& at(std::size_t case_index, std::size_t method_index) const {
    return trials[case_index * methods.size() + method_index];
  }
  /// The best of all methods; null if none found a route.
  const Trial* best_trial(std::size_t case_index) const;
  Cell cell(const Trial& trial) const;
};

/// Index of the method called `name`.
std::size_t method_index(const Experiment& experiment, std::string_view name);

/// Every method, a planner of `registry`, on every case, with nothing run yet. Planners that no seed changes get one
/// run, the others `seeds`. Throws InputError if a planner cannot serve a case.
Experiment plan_experiment(std::vector<StudyCase> cases, std::vector<StudyMethod> methods, std::uint64_t seeds,
                           const Registry& registry = builtin_planners());

/// Runs all trials of all experiments, one run a thread; false if stopped. Each run gets one thread.
bool run_experiments(const std::vector<Experiment*>& experiments, Executor& executor, const ReproduceOptions& options);

}  // namespace alate
