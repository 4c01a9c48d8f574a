#include "study/experiment.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace alate {

namespace {

struct Task {
  const StudyCase* problem;
  const StudyMethod* method;
  const ChosenPlanner* planner;
  StudyRun* run;
};

std::vector<Task> tasks_of(const std::vector<Experiment*>& experiments) {
  std::vector<Task> tasks;
  for (Experiment* experiment : experiments)
    for (Trial& trial : experiment->trials)
      for (StudyRun& run : trial.runs)
        tasks.push_back(
            {&experiment->cases[trial.case_index], &experiment->methods[trial.method_index], &trial.planner, &run});
  return tasks;
}

void run_task(const Task& task, const std::stop_token& stop) {
  Problem problem(task.problem->world);
  problem.front = task.method->front;
  *task.run = run_once(task.planner->planner, problem,
                       {.iterations = task.method->iterations, .seed = task.run->seed, .stop = stop});
}

}  // namespace

std::vector<double> Trial::costs() const {
  std::vector<double> costs;
  for (const StudyRun& run : runs)
    if (run.passed) costs.push_back(run.metrics.cost);
  return costs;
}

const StudyRun* Trial::best() const {
  const StudyRun* best = nullptr;
  for (const StudyRun& run : runs)
    if (run.passed && (best == nullptr || run.metrics.cost < best->metrics.cost)) best = &run;
  return best;
}

const Trial* Experiment::best_trial(std::size_t case_index) const {
  const Trial* best = nullptr;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Trial& trial = at(case_index, m);
    const StudyRun* run = trial.best();
    if (run != nullptr && (best == nullptr || run->metrics.cost < best->best()->metrics.cost)) best = &trial;
  }
  return best;
}

Cell Experiment::cell(const Trial& trial) const {
  Cell cell{.case_name = cases[trial.case_index].name, .method = methods[trial.method_index].name};
  cell.runs = trial.runs.size();
  for (const StudyRun& run : trial.runs) {
    cell.wall_s += run.wall_s / static_cast<double>(cell.runs);
    cell.lower_bound = run.plan.lower_bound;
  }
  if (const auto summary = trial.summary()) {
    cell.found = summary->count;
    cell.mean = summary->mean;
    cell.sd = summary->sd;
    cell.best = summary->least;
    cell.worst = summary->greatest;
  }
  return cell;
}

std::size_t method_index(const Experiment& experiment, std::string_view name) {
  const auto found = std::ranges::find(experiment.methods, name, &StudyMethod::name);
  assert(found != experiment.methods.end());
  return static_cast<std::size_t>(found - experiment.methods.begin());
}

Experiment plan_experiment(std::vector<StudyCase> cases, std::vector<StudyMethod> methods, std::uint64_t seeds,
                           const Registry& registry) {
  Experiment experiment{.cases = std::move(cases), .methods = std::move(methods)};
  for (std::size_t c = 0; c < experiment.cases.size(); ++c) {
    const Problem problem(experiment.cases[c].world);
    for (std::size_t m = 0; m < experiment.methods.size(); ++m) {
      ChosenPlanner planner = choose_planner(registry, problem, experiment.methods[m].request);
      const bool chance = !registry.find(planner.name)->can.deterministic;
      Trial trial{.case_index = c, .method_index = m, .planner = std::move(planner), .runs = {}};
      for (std::uint64_t seed = 1; seed <= (chance ? seeds : 1); ++seed) trial.runs.push_back({.seed = seed});
      experiment.trials.push_back(std::move(trial));
    }
  }
  return experiment;
}

bool run_experiments(const std::vector<Experiment*>& experiments, Executor& executor, const ReproduceOptions& options) {
  const std::vector<Task> tasks = tasks_of(experiments);
  return run_all({.count = tasks.size(),
                  .run = [&](std::size_t i) { run_task(tasks[i], options.stop); },
                  .stop = options.stop,
                  .on_progress = options.on_progress},
                 executor);
}

}  // namespace alate
