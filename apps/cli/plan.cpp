// alate plan: from a scenario to a checked route, shown and written.
#include <algorithm>
#include <memory>

#include "alate/data/scenario_file.hpp"
#include "commands.hpp"
#include "deliver.hpp"
#include "folder.hpp"
#include "progress_bar.hpp"

namespace alate::cli {

namespace {

/// The command line as written.
struct PlanLine {
  Text scenario, planner, preset, bound, prefer;
  std::vector<std::string> settings;
  std::vector<std::string> overrides;
  bool front = false;
  RunLine run;
  Delivery delivery;
};

/// The command line as understood.
struct PlanOptions {
  std::string scenario;
  PlannerRequest request;
  RunOptions run;
  int threads = 1;
  Preference prefer = Preference::length;
  bool front = false;
};

ParamSetting read_setting(const std::string& text, FaultList& faults) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    faults.add({.file = "--set", .value = text, .limit = "parameter=value", .message = "names no parameter and value"});
  const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
  return {.name = text.substr(0, equals), .text = value, .file = "--set"};
}

Preference read_preference(const Text& text, FaultList& faults) {
  const std::vector<std::string> words{"length", "corrections", "probability"};
  const auto found = std::ranges::find(words, text.value_or(words.front()));
  if (found != words.end()) return static_cast<Preference>(found - words.begin());
  faults.add(unknown_name({.file = "--prefer"}, "preference", *text, words));
  return Preference::length;
}

PlanOptions read_options(const PlanLine& line, FaultList& faults) {
  PlanOptions options;
  options.scenario = read_required("SCENARIO", line.scenario, faults);
  options.request = {.name = line.planner.value_or(""), .preset = line.preset.value_or("")};
  for (const std::string& text : line.settings) options.request.settings.push_back(read_setting(text, faults));
  if (line.bound) options.request.settings.push_back({.name = "bound", .text = *line.bound, .file = "--bound"});
  options.threads = read_threads(line.run.threads, faults);
  options.run = read_run(line.run, faults);
  options.prefer = read_preference(line.prefer, faults);
  options.front = line.front;
  if (line.delivery.out) check_folder(*line.delivery.out, faults);
  return options;
}

/// What can be said about the planner asked for when there is no world to try it on.
void check_request(const PlannerRequest& request, FaultList& faults) {
  const PlannerEntry* entry = builtin_planners().find(request.name);
  if (request.name.empty()) return;
  if (entry == nullptr) {
    faults.add(unknown_name({.file = "--planner"}, "planner", request.name, builtin_planners().names()));
    return;
  }
  std::vector<Fault> found;
  entry->parameters.resolve({}, request.settings, found);
  for (Fault& fault : found) faults.add(std::move(fault));
}

/// Fronts and preferences are about correction points.
void check_navigation(const Site& site, const PlanLine& line, FaultList& faults) {
  if (site.navigation) return;
  const std::string message = "needs a scenario with navigation; " + site.scenario.file + " has none";
  if (line.front) faults.add({.file = "--front", .message = message});
  if (line.prefer) faults.add({.file = "--prefer", .message = message});
}

Problem problem_of(const World& world, const PlanOptions& options) {
  Problem problem(world);
  problem.prefer = options.prefer;
  problem.front = options.front;
  return problem;
}

/// A problem ready to be solved.
struct Task {
  std::unique_ptr<const World> world;
  std::unique_ptr<const ChosenPlanner> planner;
};

Task read_task(const PlanLine& line, const PlanOptions& options, FaultList& faults) {
  std::optional<Scenario> scenario;
  std::optional<Site> site;
  if (!options.scenario.empty())
    scenario = faults.collect([&] { return load_scenario(options.scenario, line.overrides); });
  if (scenario) site = faults.collect([&] { return load_site(*scenario); });
  if (!site) {
    check_request(options.request, faults);
    return {};
  }
  check_navigation(*site, line, faults);
  Task task;
  task.world = std::make_unique<const World>(std::move(*site));
  task.planner = faults
                     .collect([&] {
                       return std::make_unique<const ChosenPlanner>(
                           choose_planner(builtin_planners(), problem_of(*task.world, options), options.request));
                     })
                     .value_or(nullptr);
  return task;
}

Result solve(const Task& task, const PlanOptions& options) {
  Executor executor(options.threads);
  ProgressBar bar;
  RunOptions run_options = options.run;
  run_options.on_progress = [&bar](const Progress& progress) { bar.draw(progress); };
  RunContext run(executor, std::move(run_options));
  Plan plan = task.planner->planner.plan(problem_of(*task.world, options), run);
  const double wall_s = run.elapsed_s();
  Result result = result_of(task.world->site(), *task.planner, std::move(plan));
  result.wall_s = wall_s;
  result.threads = options.threads;
  return result;
}

int plan(const PlanLine& line, FaultList faults) {
  const Interrupt interrupt;  // Before any other thread.
  PlanOptions options = read_options(line, faults);
  const Task task = read_task(line, options, faults);
  faults.throw_if_any();
  if (line.delivery.out) make_folder(*line.delivery.out);

  options.run.stop = interrupt.token();
  Result result = solve(task, options);
  return deliver(result, line.delivery, interrupt);
}

}  // namespace

void add_plan(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<PlanLine>();
  CLI::App& command =
      *add_command(app, "plan", "Plan a route, check it, show it and write it",
                   "alate plan scenario.yaml --planner beam --override terrain.clearance_m=90 --out out");
  add_text(command, "SCENARIO", line->scenario, "scenario file (YAML or JSON); - reads standard input");
  add_text(command, "--planner", line->planner, "planner to use (see alate planners); beats the scenario's");
  add_text(command, "--preset", line->preset, "named set of the planner's parameters");
  add_list(command, "--set", line->settings, "parameter=value of the planner; may be repeated");
  add_text(command, "--bound", line->bound, "quick or tight: work on the lower bound; short for --set bound=...");
  add_list(command, "--override", line->overrides, "key.path=VALUE of the scenario; may be repeated");
  add_run_options(command, line->run, "iterations at most, >= 1");
  command.add_flag("--front", line->front, "every best trade-off of length, corrections and chance of success, too");
  add_text(command, "--prefer", line->prefer, "which of them is flown: length (default), corrections or probability");
  add_delivery_options(command, line->delivery);
  command.callback([&chosen, line] { chosen = [line](FaultList faults) { return plan(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
