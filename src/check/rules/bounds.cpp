#include <algorithm>

#include "check/rules.hpp"

namespace alate {

namespace {

/// Distance to the nearest side; negative outside.
double inside(const Box2& box, const Vec2& p) { return std::min((p - box.min).minCoeff(), (box.max - p).minCoeff()); }

double inside(const HeightRaster& raster, const Vec2& xy) {
  const double from_box = inside(raster.area, xy);
  if (from_box < -kRoundingNoise) return from_box;
  const Box2 posts{Vec2::Zero(), Vec2(raster.columns - 1, raster.rows - 1)};
  return inside(posts, raster.map(xy.cwiseMax(raster.area.min).cwiseMin(raster.area.max))) * raster.cell_m;
}

double inside(const Site& site, const Vec2& xy) {
  if (site.grid) return inside(site.grid->area(), xy);
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return inside(*raster, xy);
  return inside(std::get<PeakGround>(site.ground).area, xy);
}

}  // namespace

RuleReport judge_bounds(const Flight& flight) {
  RuleReport report("bounds");
  if (!flight.site.has_ground() && !flight.site.grid) {
    report.not_checked("the scenario has no terrain, so its area has no edge");
    return report;
  }
  for (const Leg& leg : flight.legs) {
    for (const Segment& piece : leg.pieces) {
      for (const Vec3& end : {piece.a, piece.b}) {
        report.at_least({.leg = leg.index, .where = end, .value = inside(flight.site, end.head<2>()), .limit = 0});
      }
    }
  }
  return report;
}

}  // namespace alate
