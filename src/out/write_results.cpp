#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "alate/out/result.hpp"
#include "out/output_folder.hpp"
#include "out/report/report.hpp"
#include "out/route_files.hpp"
#include "out/waypoints.hpp"

namespace alate {

namespace {

/// Storage of many ArduPilot boards.
constexpr std::size_t kCommonMissionItems = 700;

constexpr const char* kResult = "result.json";
constexpr const char* kReport = "report.html";

struct RouteFormat {
  const char* name;
  std::string (*write)(const RouteToWrite&);
  bool on_earth;  ///< Needs places in WGS 84.
  bool flown;     ///< Loaded into an autopilot.
};

constexpr std::array<RouteFormat, 5> kFormats{{{"route.csv", route_csv, false, false},
                                               {"route.geojson", route_geojson, true, false},
                                               {"route.kml", route_kml, true, false},
                                               {"route.plan", route_plan, true, true},
                                               {"route.waypoints", route_waypoints, true, true}}};

struct Selection {
  std::vector<RouteFormat> written;
  std::vector<std::string> warnings;
};

Selection select(const RouteToWrite& route) {
  Selection selection;
  std::vector<std::string> no_place;
  std::vector<std::string> not_allowed;
  const bool earth = on_earth(route.points);
  for (const RouteFormat& format : kFormats) {
    if (format.on_earth && !earth)
      no_place.emplace_back(format.name);
    else if (format.flown && !route.result.verdict.ok())
      not_allowed.emplace_back(format.name);
    else
      selection.written.push_back(format);
  }
  if (!no_place.empty())
    selection.warnings.push_back(
        fmt::format("{} left out: the frame has no place on Earth", fmt::join(no_place, ", ")));
  if (!not_allowed.empty())
    selection.warnings.push_back(
        fmt::format("{} left out: the route did not pass the check", fmt::join(not_allowed, ", ")));
  return selection;
}

/// What a pilot must know about the mission files.
void warn_of_mission(const RouteToWrite& route, Selection& selection) {
  if (std::ranges::none_of(selection.written, &RouteFormat::flown)) return;
  selection.warnings.emplace_back(
      "the check covers the flight from the first to the last waypoint: take-off, the way to the start, and what the "
      "autopilot does after the last waypoint (loiter, return or land) are not part of it");
  if (const std::size_t items = mission_items(route); items > kCommonMissionItems)
    selection.warnings.push_back(fmt::format("the mission has {} items; many ArduPilot boards store no more than {}",
                                             items, kCommonMissionItems));
}

/// In the widest corners that keep every rule when flown straight from one to the next; in the widest of all where none
/// of them do.
Route mission_of(const Site& site, const Route& route) {
  constexpr double kWidest = 15 * kPi / 180;
  for (const double corner : {kWidest, kWidest / 2, kWidest / 4}) {
    Route waypoints = waypoints_of(route, corner);
    if (check(site, waypoints).violations.empty()) return waypoints;
  }
  return waypoints_of(route, kWidest);
}

/// The mission goes round corners where the route has arcs.
void warn_of_corners(const Site& site, const Route& waypoints, Selection& selection) {
  if (std::ranges::none_of(selection.written, &RouteFormat::flown)) return;
  for (const Violation& broken : check(site, waypoints).violations)
    selection.warnings.push_back(
        fmt::format("the mission has corners around the route's arcs; flown from corner to corner without rounding "
                    "them, it breaks {} by {:.2f} {} on its leg {}",
                    broken.rule, std::abs(broken.value - broken.limit), broken.unit, broken.leg));
}

}  // namespace

void write_results(const std::string& folder, Result& result) {
  OutputFolder output(folder);
  Selection selection;
  const Route waypoints = mission_of(result.site, result.plan.route);
  const RouteToWrite route{result, route_points(result.site, result.plan.route), route_points(result.site, waypoints)};
  if (!route.points.empty()) {
    selection = select(route);
    warn_of_mission(route, selection);
    if (waypoints.states.size() != result.plan.route.states.size()) warn_of_corners(result.site, waypoints, selection);
  }
  result.warnings.insert(result.warnings.end(), selection.warnings.begin(), selection.warnings.end());
  result.files = {kResult, kReport};
  for (const RouteFormat& format : selection.written) result.files.emplace_back(format.name);

  for (const RouteFormat& format : selection.written) output.write(format.name, format.write(route));
  output.write(kReport, report_html(result));
  output.write(kResult, to_json(result));
  // A route of an earlier run must not stand beside a result that does not name it.
  for (const RouteFormat& format : kFormats) {
    if (std::ranges::find(result.files, format.name) == result.files.end()) output.remove(format.name);
  }
  output.publish();
}

}  // namespace alate
