#include <nlohmann/json.hpp>

#include "alate/core/version.hpp"
#include "alate/out/result.hpp"
#include "out/json_parts.hpp"
#include "out/notes.hpp"

namespace alate {

namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// Names come from files: bytes that are not UTF-8 are replaced, never thrown about.
std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json place(const Site& site, const Vec3& where) {
  const auto geo = site.frame.to_geo(where.head<2>());
  return {{"x_m", number(where.x())},
          {"y_m", number(where.y())},
          {"z_m", number(where.z())},
          {"lat", geo ? number(geo->lat_deg) : Json()},
          {"lon", geo ? number(geo->lon_deg) : Json()}};
}

Json verdict_json(const Site& site, const Verdict& verdict) {
  Json violations = Json::array();
  for (const Violation& v : verdict.violations) {
    violations.push_back({{"rule", v.rule},
                          {"leg", v.leg},
                          {"where", place(site, v.where)},
                          {"value", number(v.value)},
                          {"limit", number(v.limit)},
                          {"unit", v.unit}});
  }
  Json margins = Json::array();
  for (const Margin& m : verdict.margins) {
    margins.push_back({{"rule", m.rule},
                       {"margin", number(m.margin)},
                       {"unit", m.unit},
                       {"leg", m.leg},
                       {"where", place(site, m.where)}});
  }
  Json not_checked = Json::array();
  for (const NotChecked& n : verdict.not_checked) not_checked.push_back({{"rule", n.rule}, {"why", n.why}});
  return {{"status", to_string(verdict.status)},
          {"ok", verdict.ok()},
          {"violations", violations},
          {"margins", margins},
          {"not_checked", not_checked}};
}

/// Without a route there is nothing to judge: no status, and certainly not ok.
Json no_verdict() {
  return {{"status", nullptr},
          {"ok", false},
          {"violations", Json::array()},
          {"margins", Json::array()},
          {"not_checked", Json::array()}};
}

Json metrics_json(const Metrics* metrics) {
  const GridMeasures* grid = metrics != nullptr && metrics->grid ? &*metrics->grid : nullptr;
  const auto value = [&](double Metrics::* member) { return metrics ? number(metrics->*member) : Json(); };
  return {{"length_m", value(&Metrics::length_m)},
          {"climb_m", value(&Metrics::climb_m)},
          {"descent_m", value(&Metrics::descent_m)},
          {"threat", value(&Metrics::threat)},
          {"min_clearance_m", metrics != nullptr ? number(metrics->min_clearance_m) : Json()},
          {"corrections", metrics != nullptr && metrics->corrections ? Json(*metrics->corrections) : Json()},
          {"probability", metrics != nullptr ? number(metrics->probability) : Json()},
          {"height_dev", grid != nullptr ? number(grid->height_deviation_m) : Json()},
          {"turns", grid != nullptr ? Json(grid->turns) : Json()},
          {"composite", grid != nullptr ? number(composite_index(*grid)) : Json()}};
}

Json front_json(const std::vector<FrontPoint>& front) {
  Json points = Json::array();
  for (const FrontPoint& point : front) {
    points.push_back({{"length_m", number(point.length_m)},
                      {"corrections", point.corrections},
                      {"probability", number(point.probability)},
                      {"points", point.points}});
  }
  return points;
}

Json ground_json(const Site& site) {
  const GroundNote ground = ground_note(site);
  return {{"kind", ground.kind},
          {"terrain", text_or_null(ground.terrain)},
          {"crs", text_or_null(ground.crs)},
          {"datum", text_or_null(ground.datum)},
          {"cell_m", number(ground.cell_m)},
          {"voids", ground.voids ? Json(*ground.voids) : Json()}};
}

Json parameters_json(const ParamValues& values) {
  Json parameters = Json::object();
  for (const auto& [name, value] : values.all()) {
    parameters[name] = std::visit(
        [](const auto& v) -> Json {
          if constexpr (std::is_same_v<std::decay_t<decltype(v)>, double>) return number(v);
          return v;
        },
        value);
  }
  return parameters;
}

Json counters_json(const Result& result) {
  Json counters{{"candidates", nullptr}, {"iterations", nullptr}};
  for (const auto& [name, count] : result.plan.counters) counters[name] = count;
  counters["wall_s"] = number(result.wall_s);
  counters["threads"] = result.threads;
  return counters;
}

}  // namespace

std::string to_json(const Result& result) {
  const Site& site = result.site;
  const bool found = !result.plan.route.empty();
  return dump({{"schema", 1},
               {"alate", version()},
               {"scenario", site.scenario.file},
               {"overrides", site.scenario.overrides},
               {"outcome", to_string(result.plan.outcome)},
               {"summary", summary(result)},
               {"stop", to_string(result.plan.stop)},
               {"planner", result.planner.name},
               {"preset", result.planner.preset},
               {"chosen_by", result.planner.chosen_by},
               {"why", result.planner.why},
               {"parameters", parameters_json(result.planner.parameters)},
               {"seed", result.plan.seed},
               {"reproducible", result.plan.reproducible},
               {"cost", found ? number(result.metrics.cost) : Json()},
               {"lower_bound", number(result.plan.lower_bound)},
               {"gap", number(gap(result))},
               {"metrics", metrics_json(found ? &result.metrics : nullptr)},
               {"verdict", found ? verdict_json(site, result.verdict) : no_verdict()},
               {"route", route_json(site, result.plan.route)},
               {"front", front_json(result.plan.front)},
               {"counters", counters_json(result)},
               {"frame", site.frame.name()},
               {"ground", ground_json(site)},
               {"files", result.files},
               {"warnings", all_warnings(result)},
               {"notice", notice(site)}});
}

std::string to_json(const std::vector<Fault>& faults) {
  Json errors = Json::array();
  for (const Fault& fault : faults) {
    errors.push_back({{"file", text_or_null(fault.file)},
                      {"line", fault.line > 0 ? Json(fault.line) : Json()},
                      {"column", fault.column > 0 ? Json(fault.column) : Json()},
                      {"field", text_or_null(fault.field)},
                      {"value", text_or_null(fault.value)},
                      {"limit", text_or_null(fault.limit)},
                      {"unit", text_or_null(fault.unit)},
                      {"message", fault.message}});
  }
  return dump({{"schema", 1}, {"errors", errors}});
}

std::string to_json(const Site& site, const Verdict& verdict, const Metrics& metrics) {
  return dump({{"schema", 1},
               {"alate", version()},
               {"scenario", text_or_null(site.scenario.file)},
               {"overrides", site.scenario.overrides},
               {"cost", number(metrics.cost)},
               {"metrics", metrics_json(&metrics)},
               {"verdict", verdict_json(site, verdict)},
               {"frame", site.frame.name()},
               {"ground", ground_json(site)},
               {"warnings", site.warnings},
               {"notice", notice(site)}});
}

}  // namespace alate
