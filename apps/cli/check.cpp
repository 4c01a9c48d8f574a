// alate check: judges a route from a file by the rules of its scenario.
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "alate/check/check.hpp"
#include "alate/data/route_file.hpp"
#include "alate/data/scenario_file.hpp"
#include "alate/out/result.hpp"
#include "alate/plan/point_route.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace alate::cli {

namespace {

namespace fs = std::filesystem;

struct CheckLine {
  Text file, scenario, points;
  std::vector<std::string> overrides;
  bool json = false;
};

/// What the route is to be judged by.
struct Ground {
  std::string scenario;
  std::vector<std::string> overrides;
};

/// The scenario a result names, seen from the current folder or else from the result's own.
std::string find_scenario(const std::string& named, const std::string& result_file) {
  std::error_code ignored;
  if (fs::exists(named, ignored)) return named;
  const fs::path beside = fs::path(result_file).parent_path() / named;
  return fs::exists(beside, ignored) ? beside.string() : named;
}

Ground recorded_ground(const std::string& file) {
  const RouteFile result = peek_result(file);
  if (result.scenario.empty() || result.scenario == "-")
    throw InputError(Fault{.file = "--scenario",
                           .value = "nothing",
                           .limit = "a scenario file",
                           .message = fmt::format("is needed: {} does not say what it is to be judged by", file)});
  return {.scenario = find_scenario(result.scenario, file), .overrides = result.overrides};
}

Site load_ground(const CheckLine& line, const std::string& file) {
  Ground ground = line.scenario ? Ground{.scenario = *line.scenario} : recorded_ground(file);
  ground.overrides.insert(ground.overrides.end(), line.overrides.begin(), line.overrides.end());
  return load_site(load_scenario(ground.scenario, ground.overrides));
}

/// The route and what it is judged by, or a fault in each of them.
struct Case {
  std::optional<Site> site;
  std::optional<RouteFile> route;
};

Case read_file(const CheckLine& line, FaultList& faults) {
  const std::string file = read_required("FILE", line.file, faults);
  if (file.empty()) return {};
  Case read;
  read.site = faults.collect([&] { return load_ground(line, file); });
  if (read.site) {
    read.route = faults.collect([&] { return load_route(file, read.site->frame); });
  } else if (line.scenario) {
    faults.collect([&] { return peek_result(file); });  // Faults of the file show even without a frame.
  }
  return read;
}

Case read_points(const CheckLine& line, FaultList& faults) {
  if (line.file)
    faults.add({.file = "--points", .limit = "FILE | --points", .message = "stands in place of a file, not beside it"});
  const std::string scenario = read_required("--scenario", line.scenario, faults);
  if (scenario.empty()) return {};
  Case read;
  read.site = faults.collect([&] { return load_site(load_scenario(scenario, line.overrides)); });
  if (read.site) {
    read.route =
        faults.collect([&] { return RouteFile{.route = route_over_points(*read.site, *line.points, "--points")}; });
  }
  return read;
}

int check_route(const CheckLine& line, FaultList faults) {
  const auto [site, route] = line.points ? read_points(line, faults) : read_file(line, faults);
  faults.throw_if_any();
  const Verdict verdict = check(*site, route->route);
  const Metrics metrics = measure(*site, route->route);
  if (line.json) {
    fmt::print("{}\n", to_json(*site, verdict, metrics));
  } else {
    const std::string name = line.points ? "The route over " + *line.points : *line.file;
    fmt::print("{}, judged by {}\n\n{}{}", name, site->scenario.file, describe(*site, metrics),
               describe(*site, verdict));
    for (const std::string& note : route->notes) fmt::print("note: {}\n", note);
    fmt::print("{}", height_note(*site));
  }
  return verdict.ok() ? kDone : kNoGoodRoute;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<CheckLine>();
  CLI::App& command = *add_command(app, "check", "Judge a route from a file, leg by leg and rule by rule",
                                   "alate check out/route.plan --scenario scenario.yaml");
  add_text(command, "FILE", line->file, "result.json, route.csv, .plan, .waypoints, KML or GeoJSON line");
  add_text(command, "--scenario", line->scenario, "what to judge by (default: what result.json was planned for)");
  add_list(command, "--override", line->overrides, "key.path=VALUE of the scenario; may be repeated");
  add_text(command, "--points", line->points, "ids of correction points, 503,294,..., in place of FILE");
  command.add_flag("--json", line->json, "verdict as JSON on standard output, and nothing else");
  command.callback(
      [&chosen, line] { chosen = [line](FaultList faults) { return check_route(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
