// alate replan: a flight that is under way, planned anew from where the aircraft is.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "alate/data/route_file.hpp"
#include "alate/data/scenario_file.hpp"
#include "alate/plan/session.hpp"
#include "commands.hpp"
#include "deliver.hpp"
#include "folder.hpp"
#include "progress_bar.hpp"

namespace alate::cli {

namespace {

struct ReplanLine {
  Text scenario, from, at;
  std::vector<std::string> overrides;
  RunLine run;
  Delivery delivery;
};

/// The flight as it was planned, and where the aircraft is.
struct Flight {
  Site site;
  Route route;
  FlightState now;
  std::vector<std::string> overrides;  ///< It was planned with.
};

/// Seconds of flight; a fault for anything but a number from 0 on.
std::optional<double> read_time(const Text& text, FaultList& faults) {
  const std::string given = read_required("--at-s", text, faults);
  if (given.empty()) return std::nullopt;
  double value = 0;
  const char* end = given.data() + given.size();
  const auto [stopped, error] = std::from_chars(given.data(), end, value);
  if (error == std::errc{} && stopped == end && std::isfinite(value) && value >= 0) return value;
  faults.add({.file = "--at-s", .value = given, .limit = ">= 0", .unit = "s", .message = "no time of flight"});
  return std::nullopt;
}

/// What the flight sets itself while it goes on.
void refuse_start(const std::vector<std::string>& overrides, FaultList& faults) {
  for (const std::string& text : overrides)
    for (const std::string group : {"start", "frame"})
      if (text.starts_with(group + ".") || text.starts_with(group + "="))
        faults.add({.file = "--override",
                    .value = text,
                    .message = fmt::format("the {} of a flight under way cannot be changed", group)});
}

Fault fault_of(const std::string& file, std::string message) { return {.file = file, .message = std::move(message)}; }

/// Throws InputError if the result holds no flight of the scenario.
Flight read_flight(const std::string& scenario, const std::string& from) {
  RouteFile origin = peek_result(from);
  if (origin.format != "result") throw InputError(fault_of(from, "is no result.json of alate"));
  Flight flight{.site = load_site(load_scenario(scenario, origin.overrides)),
                .route = {},
                .now = {},
                .overrides = origin.overrides};
  flight.route = load_route(from, flight.site.frame).route;
  constexpr double kSamePlace_m = 1;
  const double off = (flight.route.states.front().position - flight.site.mission.start).norm();
  if (off > kSamePlace_m)
    throw InputError(Fault{.file = from,
                           .field = "route.0",
                           .value = fmt::format("{:.0f}", off),
                           .limit = fmt::format("<= {}", kSamePlace_m),
                           .unit = "m from the start of " + scenario,
                           .message = "is a flight of another scenario"});
  return flight;
}

/// Throws InputError where no state in flight can be told.
FlightState state_at(const Flight& flight, double at_s, const std::string& from) {
  const auto& speed = flight.site.vehicle.speed_mps;
  if (!speed)
    throw InputError(Fault{.file = flight.site.scenario.file,
                           .field = "vehicle.speed_mps",
                           .message = "is needed to tell where the aircraft is after a time"});
  const double length = flown_length(flight.route);
  const double flown = at_s * *speed;
  if (flown > length)
    throw InputError(Fault{.file = "--at-s",
                           .value = fmt::format("{}", at_s),
                           .limit = fmt::format("0 to {:.1f}", length / *speed),
                           .unit = "s",
                           .message = "the flight is over by then"});
  const auto state = state_along(flight.route, flown);
  if (!state)
    throw InputError(fault_of(from, fmt::format("has no heading after {} s: it climbs upright there, or turns in a "
                                                "tilted plane",
                                                at_s)));
  return *state;
}

/// The scenario's own overrides, the changes, and the state in flight: what makes the result stand for itself.
std::vector<std::string> overrides_for(const Flight& flight, const std::vector<std::string>& changes,
                                       const std::string& scenario) {
  std::vector<std::string> all = flight.overrides;
  all.insert(all.end(), changes.begin(), changes.end());
  const Scenario changed = load_scenario(scenario, all);
  const Vec3& at = flight.now.position;
  all.push_back(fmt::format("start={{position_m: [{}, {}, {}], heading_deg: {}}}", at.x(), at.y(), at.z(),
                            degrees(flight.now.heading_rad)));
  if (changed.frame.crs == "auto" && !changed.frame.origin && !flight.site.frame.is_local())
    all.push_back(fmt::format("frame.crs=\"{}\"", flight.site.frame.name()));
  if (changed.vehicle.range_m) {
    const double left = *changed.vehicle.range_m - flight.now.flown_m;
    if (left <= 0)
      throw InputError(Fault{.file = changed.file,
                             .field = "vehicle.range_m",
                             .value = fmt::format("{:.0f}", flight.now.flown_m),
                             .limit = fmt::format("< {:.0f}", *changed.vehicle.range_m),
                             .unit = "m",
                             .message = "all of the range is flown by then"});
    all.push_back(fmt::format("vehicle.range_m={}", left));
  }
  return all;
}

/// What is changed, at the state in flight. Its faults are not those of the user's words.
Site site_in_flight(const Flight& flight, const ReplanLine& line, const std::string& scenario, double at_s) {
  try {
    return load_site(load_scenario(scenario, overrides_for(flight, line.overrides, scenario)));
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) {
      if (fault.file != "--override" || fault.field != "start") continue;
      fault.file = fmt::format("--at-s {}", at_s);
      fault.field = "the aircraft by then";
    }
    throw InputError(std::move(faults));
  }
}

std::string kilometres(double metres) { return fmt::format("{:.1f} km", metres / 1000); }

/// May the old route be flown on?
std::string about_old_route(const Flight& flight, const Site& now) {
  const Route rest = rest_of(flight.route, flight.now.flown_m);
  const Verdict verdict = check(now, rest);
  std::vector<std::string> broken;
  for (const Violation& each : verdict.violations)
    if (std::ranges::find(broken, each.rule) == broken.end()) broken.push_back(each.rule);
  const std::string judged = verdict.ok()     ? "still keep every rule"
                             : broken.empty() ? "can no longer be judged"
                                              : fmt::format("now break {}", fmt::join(broken, ", "));
  return fmt::format("{} of the old {} are flown; the {} that are left of it {}", kilometres(flight.now.flown_m),
                     kilometres(flown_length(flight.route)), kilometres(flown_length(rest)), judged);
}

struct Task {
  Flight flight;
  std::unique_ptr<Session> session;
};

std::optional<Task> read_task(const ReplanLine& line, const std::string& scenario, std::optional<double> at_s,
                              FaultList& faults) {
  const std::string from = read_required("--from", line.from, faults);
  if (scenario.empty() || from.empty()) return std::nullopt;
  auto flight = faults.collect([&] { return read_flight(scenario, from); });
  if (!flight || !at_s) return std::nullopt;
  return faults.collect([&] {
    flight->now = state_at(*flight, *at_s, from);
    auto session = std::make_unique<Session>(site_in_flight(*flight, line, scenario, *at_s));
    session->follow(flight->route);
    return Task{.flight = std::move(*flight), .session = std::move(session)};
  });
}

ChosenPlanner planner_for(const Site& site) {
  const World world(site);
  ChosenPlanner planner = choose_planner(builtin_planners(), Problem(world), {.name = "interval-astar"});
  planner.chosen_by = "auto";
  planner.why = "it is the planner that replans in flight";
  return planner;
}

Plan solve(Task& task, RunContext& run) {
  Plan plan = task.session->replan(task.flight.now, {}, run);
  const std::string about = about_old_route(task.flight, task.session->site());
  plan.why = plan.why.empty() ? about : fmt::format("{}; {}", plan.why, about);
  return plan;
}

int replan(const ReplanLine& line, FaultList faults) {
  const Interrupt interrupt;  // Before any other thread.
  const std::string scenario = read_required("SCENARIO", line.scenario, faults);
  if (scenario == "-")
    faults.add({.file = "SCENARIO", .value = "-", .message = "is read more than once here, so it must be a file"});
  const auto at_s = read_time(line.at, faults);
  const int threads = read_threads(line.run.threads, faults);
  RunOptions options = read_run(line.run, faults);
  options.stop = interrupt.token();
  refuse_start(line.overrides, faults);
  if (line.delivery.out) check_folder(*line.delivery.out, faults);
  auto task = read_task(line, scenario == "-" ? "" : scenario, at_s, faults);
  faults.throw_if_any();
  if (line.delivery.out) make_folder(*line.delivery.out);

  const ChosenPlanner planner = planner_for(task->session->site());
  Executor executor(threads);
  ProgressBar bar;
  options.on_progress = [&bar](const Progress& progress) { bar.draw(progress); };
  RunContext run(executor, std::move(options));
  Plan plan = solve(*task, run);
  const double wall_s = run.elapsed_s();
  Result result = result_of(task->session->site(), planner, std::move(plan));
  result.wall_s = wall_s;
  result.threads = threads;
  return deliver(result, line.delivery, interrupt);
}

}  // namespace

void add_replan(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<ReplanLine>();
  CLI::App& command = *add_command(app, "replan", "Plan a flight anew from where the aircraft is by now",
                                   "alate replan scenario.yaml --from out/result.json --at-s 400 \\\n"
                                   "    --override 'threats.0.core_m=1500' --out out2");
  add_text(command, "SCENARIO", line->scenario, "scenario file (YAML or JSON) that the flight was planned for");
  add_text(command, "--from", line->from, "result.json of the flight; its overrides still hold");
  add_text(command, "--at-s", line->at, "seconds flown, at the vehicle's speed_mps along the route");
  add_list(command, "--override", line->overrides, "what has changed, key.path=VALUE; may be repeated");
  add_run_options(command, line->run, "iterations at most, >= 1; the first one finds a route");
  add_delivery_options(command, line->delivery);
  command.callback([&chosen, line] { chosen = [line](FaultList faults) { return replan(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
