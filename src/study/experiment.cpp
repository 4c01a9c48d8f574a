#include "study/experiment.hpp"

#include <algorithm>
#include <cassert>
#include <mutex>
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
  Executor alone(1);
  RunContext context(alone, {.iterations = task.method->iterations, .seed = task.run->seed, .stop = stop});
  Problem problem(task.problem->world);
  problem.front = task.method->front;
  Plan plan = task.planner->planner.plan(problem, context);
  task.run->wall_s = context.elapsed_s();
  task.run->metrics = measure(task.problem->site(), plan.route);
  task.run->passed = !plan.route.empty() && check(task.problem->site(), plan.route).ok();
  if (!task.method->keep_routes) plan.route = {};
  // A copy: what was allotted while the planner held its tables lies between them, and would keep their room from use.
  task.run->plan = std::as_const(plan);
}

/// Counts finished runs and tells the sink.
class Counter {
 public:
  Counter(std::size_t total, const std::function<void(const Progress&)>& sink) : total_(total), sink_(sink) {}

  void finish_one() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (sink_) sink_({.iteration = done_, .fraction = static_cast<double>(done_) / static_cast<double>(total_)});
  }

 private:
  std::size_t total_;
  const std::function<void(const Progress&)>& sink_;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
};

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
  Counter counter(tasks.size(), options.on_progress);
  executor.for_ranges(tasks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !options.stop.stop_requested(); ++i) {
      run_task(tasks[i], options.stop);
      counter.finish_one();
    }
  });
  return !options.stop.stop_requested();
}

}  // namespace alate
