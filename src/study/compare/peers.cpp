#include "study/compare/peers.hpp"

#include <fmt/core.h>

#include "alate/core/fault.hpp"
#include "alate/data/scenario_file.hpp"
#include "data/route_formats.hpp"

namespace alate {

namespace {

constexpr double kSlack_s = 2;       ///< Beyond its time, to write and to end,
constexpr double kSlackShare = 0.2;  ///< and a share of its time.
constexpr std::size_t kMaxRoutes = 100'000;

/// The object that a line holds; nothing if it holds none.
std::optional<Json> object_in(const std::string& line) {
  Json json = Json::parse(line, nullptr, false);
  return json.is_object() ? std::optional(std::move(json)) : std::nullopt;
}

std::string text_in(const Json& json, const char* key) {
  const Json& value = member(json, key);
  return value.is_string() ? value.get<std::string>() : "";
}

bool read_list(const Json& json, std::vector<PeerPlanner>& planners) {
  const Json& list = member(json, "peers");
  if (!list.is_array()) return false;
  for (const Json& each : list) {
    planners.push_back(
        {.name = text_in(each, "name"), .help = text_in(each, "help"), .refuses = text_in(each, "refuses")});
    if (planners.back().name.empty()) return false;
  }
  return true;
}

/// What one peer says while it plans.
class PeerEar {
 public:
  PeerEar(const PeerTask& task, const Site& site, PeerRun& run) : task_(task), site_(site), run_(run) {}

  bool hear(const std::string& line, double elapsed_s) {
    const auto json = object_in(line);
    if (!json || done_) return false;
    if (!ready_) return ready_ = member(*json, "ready") == true;
    if (member(*json, "done") == true) return done_ = true;
    return run_.routes.size() < kMaxRoutes && take_route(*json, elapsed_s);
  }
  bool done() const { return done_; }

 private:
  /// No route can be older than the child.
  bool take_route(const Json& json, double elapsed_s) {
    const Json& time = member(json, "time_s");
    if (!time.is_number()) return false;
    const double time_s = time;
    if (time_s < 0 || time_s > elapsed_s) return false;
    try {
      RouteBuilder builder(site_.frame, task_.name, "result");
      read_result(json, builder);
      run_.routes.push_back({.time_s = time_s, .route = builder.finish().route});
    } catch (const InputError&) {
      return false;
    }
    return true;
  }

  const PeerTask& task_;
  const Site& site_;
  PeerRun& run_;
  bool ready_ = false;
  bool done_ = false;
};

}  // namespace

PeerList list_peers(const std::string& program, const Site& site, const std::stop_token& stop) {
  PeerList list;
  bool heard = false;
  list.end = call_peer({.words = {program, "list"}, .input = to_yaml(site.scenario)}, stop,
                       [&](const std::string& line, double /*elapsed_s*/) {
                         const auto json = object_in(line);
                         return !std::exchange(heard, true) && json && read_list(*json, list.planners);
                       });
  if (list.end.ending == PeerEnding::finished && !heard) list.end = {PeerEnding::rubbish, "named no planners"};
  if (list.end.ending != PeerEnding::finished) list.planners.clear();
  return list;
}

PeerRun run_peer(const PeerTask& task, const Site& site, const std::stop_token& stop) {
  PeerRun run;
  PeerEar ear(task, site, run);
  const PeerCall call{
      .words = {task.program, "run", task.name, fmt::format("{}", task.seconds), fmt::format("{}", task.seed)},
      .input = to_yaml(site.scenario),
      .limit_s = (1 + kSlackShare) * task.seconds + kSlack_s};
  run.end = call_peer(call, stop, [&](const std::string& line, double elapsed_s) { return ear.hear(line, elapsed_s); });
  if (run.end.ending == PeerEnding::finished && !ear.done())
    run.end = {PeerEnding::rubbish, "ended before it said that it was done"};
  return run;
}

}  // namespace alate
