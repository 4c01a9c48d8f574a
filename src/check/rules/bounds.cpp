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

/// As above, of the box that the cells fill.
double inside(const VoxelGrid& voxels, const Vec3& p) {
  return std::min(p.minCoeff(), (voxels.extent() * voxels.cell_m - p).minCoeff());
}

double inside(const Site& site, const Vec3& place) {
  if (site.voxels) return inside(*site.voxels, place);
  const Vec2 xy = place.head<2>();
  if (site.grid) return inside(site.grid->area(), xy);
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return inside(*raster, xy);
  return inside(std::get<PeakGround>(site.ground).area, xy);
}

}  // namespace

RuleReport judge_bounds(const Flight& flight) {
  RuleReport report("bounds");
  if (!flight.site.has_ground() && !flight.site.grid && !flight.site.voxels) {
    report.not_checked("the scenario has no terrain, so its area has no edge");
    return report;
  }
  for (const Leg& leg : flight.legs) {
    for (const Segment& piece : leg.pieces) {
      for (const Vec3& end : {piece.a, piece.b}) {
        report.at_least({.leg = leg.index, .where = end, .value = inside(flight.site, end), .limit = 0});
      }
    }
  }
  return report;
}

}  // namespace alate
