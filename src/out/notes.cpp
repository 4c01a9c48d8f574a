#include "out/notes.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// A sentence out of a clause: ends in a full stop.
std::string sentence(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') text.front() -= 'a' - 'A';
  return text;
}

std::string no_route(const Plan& plan) {
  const char* opening = plan.outcome == Outcome::infeasible_proven ? "There is no route" : "No route was found";
  return sentence(plan.why.empty() ? opening : fmt::format("{}: {}", opening, plan.why));
}

std::vector<std::string> broken_rules(const Verdict& verdict) {
  std::vector<std::string> names;
  for (const Violation& violation : verdict.violations) {
    if (std::ranges::find(names, violation.rule) == names.end()) names.push_back(violation.rule);
  }
  return names;
}

std::vector<std::string> unknown_rules(const Verdict& verdict) {
  std::vector<std::string> names;
  for (const NotChecked& rule : verdict.not_checked) {
    if (rule.unknown) names.push_back(rule.rule);
  }
  return names;
}

std::string judgement(const Verdict& verdict) {
  switch (verdict.status) {
    case Status::pass:
      return fmt::format(" that keeps all {} rules that were judged", verdict.margins.size());
    case Status::fail:
      return fmt::format(", but it must not be flown: it breaks {}", fmt::join(broken_rules(verdict), ", "));
    case Status::unknown:
      break;
  }
  return fmt::format(", but the data do not reach far enough to judge {}", fmt::join(unknown_rules(verdict), ", "));
}

/// " with 8 corrections"; empty without navigation errors.
std::string corrections_in_words(const Metrics& metrics) {
  if (!metrics.corrections) return {};
  return fmt::format(" with {} {}", *metrics.corrections, *metrics.corrections == 1 ? "correction" : "corrections");
}

/// Told only where points may fail.
std::string success_in_words(const Result& result) {
  const auto& navigation = result.site.navigation;
  const auto fails = [](const CorrectionPoint& point) { return point.success < 1; };
  if (!navigation || !result.metrics.probability || std::ranges::none_of(navigation->points, fails)) return {};
  if (*result.metrics.probability >= 1) return " It succeeds even if every correction that may fail does.";
  return fmt::format(" As corrections may fail, it succeeds with a chance of {}.",
                     chance_in_words(*result.metrics.probability));
}

}  // namespace

GroundNote ground_note(const Site& site) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) {
    return {.kind = "raster",
            .terrain = raster->name,
            .crs = raster->crs,
            .datum = raster->datum,
            .cell_m = raster->cell_m,
            .voids = raster->voids};
  }
  if (const auto* peaks = std::get_if<PeakGround>(&site.ground)) {
    return {.kind = "peaks",
            .terrain = fmt::format("{} analytic {}", peaks->peaks.size(), peaks->peaks.size() == 1 ? "hill" : "hills"),
            .datum = "heights as given in the scenario"};
  }
  if (site.grid) {
    return {.kind = "grid",
            .terrain = fmt::format("grid of {} x {} cells", site.grid->columns, site.grid->rows),
            .cell_m = site.grid->cell_m};
  }
  if (site.voxels) {
    const auto& [x, y, z] = site.voxels->size();
    return {
        .kind = "voxels", .terrain = fmt::format("map of {} x {} x {} voxels", x, y, z), .cell_m = site.voxels->cell_m};
  }
  return {.kind = "none"};
}

std::string notice(const Site& site) {
  const GroundNote ground = ground_note(site);
  if (site.grid && !site.has_ground()) {
    return fmt::format(
        "Planning help, not clearance to fly. The ground is a {}, {:.3g} m wide, free or blocked; the route lies in "
        "their plane, and heights are marks of the cells.",
        ground.terrain, site.grid->cell_m);
  }
  if (site.voxels) {
    return fmt::format(
        "Planning help, not clearance to fly. The air is a {}, {:.3g} m wide, free or blocked; heights are metres "
        "above "
        "its floor.",
        ground.terrain, site.voxels->cell_m);
  }
  std::string text = "Planning help, not clearance to fly. Heights are metres above mean sea level";
  if (!ground.datum.empty()) text += fmt::format(" (vertical datum of the terrain: {})", ground.datum);
  text += ". ";
  if (ground.kind == "none") return text + "No terrain was given, so nothing is known about the ground.";
  text += "Terrain: " + ground.terrain;
  if (ground.cell_m) text += fmt::format(", one height every {:.3g} m", *ground.cell_m);
  if (site.grid)
    text += fmt::format(", cut into {} x {} cells, {:.3g} m wide, for flight at {:.0f} m", site.grid->columns,
                        site.grid->rows, site.grid->cell_m, site.grid->level_m);
  return text + ". Trees, masts and wires are not in it.";
}

std::vector<std::string> all_warnings(const Result& result) {
  std::vector<std::string> all;
  for (const auto& warnings : {result.site.warnings, result.warnings}) {
    for (const std::string& warning : warnings) {
      if (std::ranges::find(all, warning) == all.end()) all.push_back(warning);
    }
  }
  return all;
}

std::optional<double> gap(const Result& result) {
  const double bound = result.plan.lower_bound;
  if (result.plan.route.empty() || !(bound > 0)) return std::nullopt;
  const double value = (result.metrics.cost - bound) / bound;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string gap_in_words(const Result& result) {
  const auto value = gap(result);
  if (!value) return "how far from the best possible is not known";
  if (*value < 5e-4) return "as good as the best possible";
  return fmt::format("at most {:.1f} % above the best possible", 100 * *value);
}

std::string length_in_words(double metres) {
  return metres < 1000 ? fmt::format("{:.0f} m", metres) : fmt::format("{:.1f} km", metres / 1000);
}

std::string chance_in_words(double chance) {
  // Rounded away from the ends: 99.99 % is not certain.
  if (chance <= 0) return "0 %";
  if (chance >= 1) return "100 %";
  return fmt::format("{:.1f} %", std::clamp(100 * chance, 0.1, 99.9));
}

std::string front_in_words(const std::vector<FrontPoint>& front) {
  constexpr std::size_t kShown = 4;
  if (front.size() < 2) return {};
  const bool unsure = std::ranges::any_of(front, [](const FrontPoint& point) { return point.probability < 1; });
  std::vector<std::string> items;
  for (const FrontPoint& point : front) {
    if (items.size() == kShown) break;
    std::string item =
        fmt::format("{} {} over {}", point.corrections, point.corrections == 1 ? "correction" : "corrections",
                    length_in_words(point.length_m));
    if (unsure) item += fmt::format(" ({})", chance_in_words(point.probability));
    items.push_back(std::move(item));
  }
  std::string text = fmt::format("{} best trade-offs are known: {}", front.size(), fmt::join(items, "; "));
  if (front.size() > items.size()) text += fmt::format("; and {} more", front.size() - items.size());
  return text + ".";
}

std::string summary(const Result& result) {
  if (result.plan.route.empty()) return no_route(result.plan);
  std::string text = fmt::format("A route of {}{} was found{}.", length_in_words(result.metrics.length_m),
                                 corrections_in_words(result.metrics), judgement(result.verdict));
  if (result.verdict.ok() && gap(result)) text += fmt::format(" Its cost is {}.", gap_in_words(result));
  if (!result.plan.why.empty()) text += fmt::format(" {}", capitalised(sentence(result.plan.why)));
  if (result.verdict.ok()) text += success_in_words(result);
  if (const std::string front = front_in_words(result.plan.front); !front.empty()) text += " " + front;
  return text;
}

}  // namespace alate
