#include <fmt/core.h>

#include <algorithm>

#include "check/rules.hpp"

namespace alate {

namespace {

/// Says on which leg the ground is unknown, if it is.
void report_unknown(const Leg& leg, RuleReport& report) {
  if (!leg.above_ground.unknown) return;
  const Vec3& at = *leg.above_ground.unknown;
  report.not_checked(
      fmt::format("the terrain has no data under leg {}, at x {:.1f} m, y {:.1f} m", leg.index, at.x(), at.y()), true);
}

void judge_height_above_sea(const Leg& leg, double ceiling_m, RuleReport& report) {
  for (const Segment& piece : leg.pieces) {
    const Vec3& top = piece.a.z() > piece.b.z() ? piece.a : piece.b;
    report.at_most({.leg = leg.index, .where = top, .value = top.z(), .limit = ceiling_m});
  }
}

}  // namespace

RuleReport judge_terrain_clearance(const Flight& flight) {
  RuleReport report("terrain_clearance");
  if (flight.site.grid ||
      flight.site.voxels) {  // over ground a leg may have two findings: one for its cells, one for its height
    judge_blocked_cells(flight, report);
  } else if (!flight.site.has_ground()) {
    report.not_checked("the scenario has no terrain");
  }
  for (const Leg& leg : flight.legs) {
    report_unknown(leg, report);
    const auto& lowest = leg.above_ground.lowest;
    if (!lowest) continue;
    report.at_least(
        {.leg = leg.index, .where = lowest->where, .value = lowest->height_m, .limit = flight.site.band.clearance_m});
  }
  return report;
}

RuleReport judge_ceiling(const Flight& flight) {
  RuleReport report("ceiling");
  const auto& [clearance, above_ground, above_sea] = flight.site.band;
  if (!above_ground && !above_sea) report.not_checked("the scenario gives no ceiling_agl_m or ceiling_amsl_m");
  if (above_ground && !flight.site.has_ground()) report.not_checked("a ceiling above ground needs terrain");
  for (const Leg& leg : flight.legs) {
    if (above_sea) judge_height_above_sea(leg, *above_sea, report);
    if (!above_ground) continue;
    report_unknown(leg, report);
    const auto& highest = leg.above_ground.highest;
    if (!highest) continue;
    report.at_most({.leg = leg.index, .where = highest->where, .value = highest->height_m, .limit = *above_ground});
  }
  return report;
}

}  // namespace alate
