#include "alate/study/scen.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "alate/check/check.hpp"
#include "data/scen_file.hpp"
#include "study/statistics.hpp"

namespace alate {

namespace {

/// A row, whatever kind of map it is on.
struct ScenTask {
  Mission mission;
  double optimum = 0;  ///< m
};

/// What every reader of tasks makes: the site without ends, and the ends.
struct ScenTasks {
  Site site;
  std::vector<ScenTask> tasks;
};

ScenTasks tasks_on_grid(ScenFile file) {
  ScenTasks all;
  all.tasks.reserve(file.rows.size());
  for (const ScenRow& row : file.rows) {
    const Mission mission{.start = file.grid.center(row.start_column, row.start_row),
                          .goal = file.grid.center(row.goal_column, row.goal_row)};
    all.tasks.push_back({mission, row.optimum * file.grid.cell_m});
  }
  all.site.grid = std::move(file.grid);
  return all;
}

ScenTasks tasks_among_voxels(VoxelScenFile file) {
  ScenTasks all;
  all.tasks.reserve(file.rows.size());
  for (const VoxelScenRow& row : file.rows) {
    const Mission mission{.start = file.voxels.center(row.start), .goal = file.voxels.center(row.goal)};
    all.tasks.push_back({mission, row.optimum * file.voxels.cell_m});
  }
  all.site.voxels = std::move(file.voxels);
  return all;
}

/// No tasks, and faults, where the file cannot be read.
ScenTasks tasks_of(const std::string& file, std::vector<Fault>& faults) {
  if (file.ends_with(".3dscen")) {
    auto scen = read_voxel_scen_file(file, faults);
    return scen ? tasks_among_voxels(std::move(*scen)) : ScenTasks{};
  }
  auto scen = read_scen_file(file, faults);
  return scen ? tasks_on_grid(std::move(*scen)) : ScenTasks{};
}

ScenTasks read_tasks(const std::string& file, const ScenOptions& options) {
  std::vector<Fault> faults;
  ScenTasks all = tasks_of(file, faults);
  const std::string& name = options.request.name;
  const Registry& planners = builtin_planners();
  if (!name.empty() && planners.find(name) == nullptr)
    faults.push_back(unknown_name({.file = "--planner"}, "planner", name, planners.names()));
  throw_if_any(std::move(faults));
  all.site.scenario.file = file;
  all.site.scenario.objective.climb = 0;
  std::ranges::stable_sort(all.tasks, std::ranges::greater{}, &ScenTask::optimum);
  if (options.rows) all.tasks.resize(std::min(all.tasks.size(), static_cast<std::size_t>(*options.rows)));
  all.site.mission = all.tasks.front().mission;
  return all;
}

/// Runs rows one by one.
class Bench {
 public:
  Bench(const Site& site, const ScenOptions& options)
      : options_(options),
        world_(site),
        judged_(site),
        chosen_(choose_planner(builtin_planners(), Problem(world_), options.request)) {
    summary_ = {.planner = chosen_.name, .preset = chosen_.preset, .why = chosen_.why};
    std::stop_source stopped;
    stopped.request_stop();
    RunContext run(executor_, {.stop = stopped.get_token()});
    chosen_.planner.plan(Problem(world_), run);
  }

  /// False if the run was stopped.
  bool run(const ScenTask& task) {
    judged_.mission = task.mission;
    const Problem problem(world_, judged_.mission);
    RunContext run(executor_, {.stop = options_.stop});
    const Plan plan = chosen_.planner.plan(problem, run);
    const double seconds = run.elapsed_s();
    if (plan.stop == Stop::cancelled) return false;
    seconds_.push_back(seconds);
    ++summary_.rows;
    if (!plan.route.empty() && check(judged_, plan.route).ok()) judge(task, measure(judged_, plan.route).length_m);
    return true;
  }

  ScenSummary summary() {
    if (!gaps_.empty()) summary_.mean_gap = summarize(gaps_)->mean;
    if (seconds_.empty()) return summary_;
    summary_.mean_s = summarize(seconds_)->mean;
    const std::size_t rank = (99 * seconds_.size() + 99) / 100;
    std::ranges::nth_element(seconds_, seconds_.begin() + static_cast<std::ptrdiff_t>(rank - 1));
    summary_.p99_s = seconds_[rank - 1];
    return summary_;
  }

 private:
  void judge(const ScenTask& task, double length_m) {
    const double tolerance_m = scen_tolerance(task.optimum);
    ++summary_.solved;
    if (std::abs(length_m - task.optimum) <= tolerance_m)
      ++summary_.optimal;
    else if (length_m < task.optimum)
      ++summary_.shorter;
    gaps_.push_back(task.optimum > 0 ? length_m / task.optimum - 1 : 0);
  }

  const ScenOptions& options_;
  Executor executor_{1};
  World world_;
  Site judged_;  ///< With the ends of the row.
  ChosenPlanner chosen_;
  ScenSummary summary_;
  std::vector<double> gaps_, seconds_;
};

}  // namespace

ScenSummary run_scen(const std::string& file, const ScenOptions& options) {
  const ScenTasks all = read_tasks(file, options);
  Bench bench(all.site, options);
  bool stopped = false;
  for (std::size_t i = 0; i < all.tasks.size() && !stopped; ++i) {
    stopped = !bench.run(all.tasks[i]);
    const auto done = static_cast<double>(i + 1);
    if (options.on_progress)
      options.on_progress({.iteration = i + 1, .fraction = done / static_cast<double>(all.tasks.size())});
  }
  ScenSummary summary = bench.summary();
  summary.stopped = stopped;
  return summary;
}

std::string to_text(const ScenSummary& s) {
  const auto number = [](const std::optional<double>& value, double factor, const char* unit) {
    return value ? fmt::format("{:.4g} {}", *value * factor, unit) : std::string("none");
  };
  std::string text = fmt::format("{} ({}): {}\n", s.planner, s.preset, s.why);
  text += fmt::format("rows      {}{}\n", s.rows, s.stopped ? ", then interrupted" : "");
  text += fmt::format("solved    {}, every route checked\n", s.solved);
  text += fmt::format("optimal   {}, as long as published\n", s.optimal);
  if (s.shorter > 0) text += fmt::format("shorter   {}, as the published lengths are from cell to cell\n", s.shorter);
  text += fmt::format("mean gap  {}\n", number(s.mean_gap, 100, "%"));
  text += fmt::format("time      {} mean, {} for 99 of 100 rows\n", number(s.mean_s, 1e3, "ms"),
                      number(s.p99_s, 1e3, "ms"));
  return text +
         "Timed is planning alone, on one thread: not reading the map, what is prepared once for it, or the check.\n";
}

std::string to_json(const ScenSummary& s) {
  using Json = nlohmann::ordered_json;
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  const Json json{{"rows", s.rows},
                  {"solved", s.solved},
                  {"optimal", s.optimal},
                  {"shorter", s.shorter},
                  {"mean_gap", number(s.mean_gap)},
                  {"mean_s", number(s.mean_s)},
                  {"p99_s", number(s.p99_s)},
                  {"planner", s.planner},
                  {"preset", s.preset}};
  return json.dump(2) + "\n";
}

}  // namespace alate
