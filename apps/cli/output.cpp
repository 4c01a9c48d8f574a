#include "output.hpp"

#include <fmt/core.h>

#include <cmath>

namespace alate::cli {

namespace {

std::string row(const std::string& name, const std::string& text) { return fmt::format("{:<12} {}\n", name, text); }

/// "36.31570 N 84.25440 W, 812 m", or frame metres where there is no place on Earth.
std::string place(const Site& site, const Vec3& where) {
  const auto geo = site.frame.to_geo(where.head<2>());
  if (!geo) return fmt::format("x {:.1f} m, y {:.1f} m, z {:.1f} m", where.x(), where.y(), where.z());
  return fmt::format("{:.5f} {} {:.5f} {}, {:.0f} m", std::abs(geo->lat_deg), geo->lat_deg < 0 ? 'S' : 'N',
                     std::abs(geo->lon_deg), geo->lon_deg < 0 ? 'W' : 'E', where.z());
}

/// Unit of costs and exposures: metres of flight, or a pure number in the other model.
std::string cost_unit(const Site& site) { return site.scenario.objective.model == CostModel::physical ? " m" : ""; }

std::string cost_line(const Result& result) {
  const std::string unit = cost_unit(result.site);
  std::string text = fmt::format("{:.2f}{}; no route costs less than {:.2f}{}", result.metrics.cost, unit,
                                 result.plan.lower_bound, unit);
  if (const auto share = gap(result)) text += fmt::format(" (gap {:.1f} %)", 100 * *share);
  return text;
}

std::string run_line(const Result& result) {
  return fmt::format("{} after {:.2f} s, threads {}, seed {}, {}", to_string(result.plan.stop), result.wall_s,
                     result.threads, result.plan.seed,
                     result.plan.reproducible ? "the same again every time" : "cut short, not reproducible");
}

/// Without the sign that rounding leaves before a zero.
std::string number(double value) {
  const std::string text = fmt::format("{:.2f}", value);
  return text == "-0.00" ? "0.00" : text;
}

std::string margin_row(const Site& site, const Margin& each) {
  return fmt::format("  {:<18} {:>10} {:<4} leg {}, {}\n", each.rule, number(each.margin), each.unit, each.leg,
                     place(site, each.where));
}

std::string violation_row(const Site& site, const Violation& each) {
  return fmt::format("  BROKEN {}: {:.2f} {}, allowed {:.2f} {}, leg {}, {}\n", each.rule, each.value, each.unit,
                     each.limit, each.unit, each.leg, place(site, each.where));
}

}  // namespace

std::string describe(const Site& site, const Metrics& metrics) {
  std::string text = row("length", fmt::format("{:.0f} m, up {:.0f} m, down {:.0f} m", metrics.length_m,
                                               metrics.climb_m, metrics.descent_m));
  text += row("exposure", fmt::format("{:.2f}{} to threats", metrics.threat, cost_unit(site)));
  if (metrics.corrections) text += row("corrections", fmt::format("{}", *metrics.corrections));
  if (metrics.probability) text += row("success", fmt::format("{:.2f} %", 100 * *metrics.probability));
  if (const auto& grid = metrics.grid) {
    text += row("grid", fmt::format("{:.4f} cells, {} turns, deviation of height {:.4f} m, composite index {:.2f}",
                                    grid->length_cells, grid->turns, grid->height_deviation_m, composite_index(*grid)));
  }
  if (metrics.min_clearance_m)
    text += row("clearance", fmt::format("{:.1f} m above ground at the lowest", *metrics.min_clearance_m));
  return text;
}

std::string describe(const Site& site, const Verdict& verdict) {
  std::string text = row("verdict", to_string(verdict.status));
  if (!verdict.margins.empty()) text += fmt::format("  {:<18} {:>10} {:<4} {}\n", "rule", "margin", "", "at its worst");
  for (const Margin& each : verdict.margins) text += margin_row(site, each);
  for (const Violation& each : verdict.violations) text += violation_row(site, each);
  for (const NotChecked& each : verdict.not_checked)
    text += fmt::format("  {} {}: {}\n", each.unknown ? "UNKNOWN" : "not checked:", each.rule, each.why);
  return text;
}

std::string describe(const Result& result) {
  std::string text = summary(result) + "\n\n";
  text +=
      row("planner", fmt::format("{}, preset {}. {}", result.planner.name, result.planner.preset, result.planner.why));
  if (!result.plan.route.empty()) {
    text += row("cost", cost_line(result));
    text += describe(result.site, result.metrics);
  }
  text += row("run", run_line(result));
  if (!result.plan.route.empty()) text += describe(result.site, result.verdict);
  for (const std::string& warning : result.warnings) text += fmt::format("warning: {}\n", warning);
  return text + height_note(result.site);
}

std::string height_note(const Site& site) {
  if (site.grid && !site.has_ground()) {
    return "The route lies in the plane of the grid; heights are marks of its cells.\n"
           "Planning help, not clearance to fly.\n";
  }
  if (site.voxels) return "Heights are metres above the floor of the map.\nPlanning help, not clearance to fly.\n";
  std::string text = "Heights are metres above mean sea level";
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground))
    text += fmt::format("; terrain {}, {:.0f} m cells, datum {}", raster->name, raster->cell_m, raster->datum);
  if (!site.has_ground()) text += "; no terrain was given";
  return text + ".\nTrees, masts and wires may be missing in it: planning help, not clearance to fly.\n";
}

}  // namespace alate::cli
