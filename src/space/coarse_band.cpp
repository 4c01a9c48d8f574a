#include "space/coarse_band.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace alate {

namespace {

constexpr double kOpenMargin = 0.2;
/// Thousands of threats make a cell take milliseconds.
constexpr std::size_t kPollEvery = 8;
constexpr double kSmallestCell = 1e-6;

/// Start, goal and all threats with a margin, for a world without ground.
Box2 open_area(const Site& site) {
  const Vec2 start = site.mission.start.head<2>();
  const Vec2 goal = site.mission.goal.head<2>();
  Box2 area{.min = start.cwiseMin(goal), .max = start.cwiseMax(goal)};
  for (const Threat& threat : site.threats) {
    area.min = area.min.cwiseMin(threat.center.head<2>() - Vec2::Constant(threat.radius_m));
    area.max = area.max.cwiseMax(threat.center.head<2>() + Vec2::Constant(threat.radius_m));
  }
  const Vec2 margin = Vec2::Constant(kOpenMargin * (area.max - area.min).norm());
  return {.min = area.min - margin, .max = area.max + margin};
}

Box2 area_of(const Site& site) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return raster->area;
  if (const auto* hills = std::get_if<PeakGround>(&site.ground)) return hills->area;
  return open_area(site);
}

}  // namespace

CoarseBand::CoarseBand(const World& world, RunContext& run, double least_m) : area_(area_of(world.site())) {
  const Vec2 extent = area_.max - area_.min;
  cell_m_ = std::max({std::sqrt(extent.x() * extent.y() / kCells), extent.maxCoeff() / kCells, kSmallestCell, least_m});
  columns_ = std::max(1, static_cast<int>(std::ceil(extent.x() / cell_m_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(extent.y() / cell_m_)));
  floor_.assign(size(), kInfinity);
  ceiling_.assign(size(), -kInfinity);
  threat_.assign(size() * kLayers, 0);
  const auto may_go_on = [&](std::size_t cell) { return cell % kPollEvery != 0 || run.keep_going(); };
  for (std::size_t cell = 0; cell < size() && may_go_on(cell); ++cell) sample_ground(world, cell);
  close_upwards(world.site());
  for (std::size_t cell = 0; cell < size() && may_go_on(cell); ++cell)
    if (!blocked(cell)) sample_threat(world, cell);
}

void CoarseBand::close_upwards(const Site& site) {
  double top = std::max(site.mission.start.z(), site.mission.goal.z());
  for (const double floor : floor_)
    if (floor < kInfinity) top = std::max(top, floor);
  for (double& ceiling : ceiling_) ceiling = std::min(ceiling, top + cell_m_);
}

Vec2 CoarseBand::center(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t row = cell / columns;
  return area_.min + cell_m_ * Vec2(static_cast<double>(cell % columns) + 0.5, static_cast<double>(row) + 0.5);
}

void CoarseBand::sample_ground(const World& world, std::size_t cell) {
  const Band& band = world.site().band;
  if (!world.site().has_ground()) {
    floor_[cell] = std::min(world.site().mission.start.z(), world.site().mission.goal.z()) - cell_m_;
    ceiling_[cell] = kInfinity;
    return;
  }
  const Vec2 corner = center(cell) - Vec2::Constant(cell_m_ / 2);
  for (int j = 0; j < kSamplesAcross; ++j) {
    for (int i = 0; i < kSamplesAcross; ++i) {
      const auto ground = world.height(corner + Vec2(i + 0.5, j + 0.5) * (cell_m_ / kSamplesAcross));
      if (!ground || std::isnan(*ground)) continue;
      const double floor = *ground + band.clearance_m;
      const double ceiling = std::min(band.ceiling_amsl_m.value_or(kInfinity),
                                      band.ceiling_agl_m ? *ground + *band.ceiling_agl_m : kInfinity);
      if (floor > ceiling) continue;
      floor_[cell] = std::min(floor_[cell], floor);
      ceiling_[cell] = std::max(ceiling_[cell], ceiling);
    }
  }
}

void CoarseBand::sample_threat(const World& world, std::size_t cell) {
  const Vec2 middle = center(cell);
  const double half = cell_m_ / 4;
  const bool near = std::ranges::any_of(world.site().threats, [&](const Threat& threat) {
    const double reach = std::max(threat.radius_m, threat.core_m) + cell_m_;
    return (middle - threat.center.head<2>()).squaredNorm() < reach * reach;
  });
  if (!near) return;
  for (int layer = 0; layer < kLayers; ++layer) {
    const double z = altitude(cell, layer);
    const Vec3 here(middle.x(), middle.y(), z);
    const Segment leg{here - Vec3(half, 0, 0), here + Vec3(half, 0, 0)};
    threat_[cell * kLayers + static_cast<std::size_t>(layer)] =
        world.enters_core({here, here}) ? kInfinity : world.exposure(leg) / (2 * half);
  }
}

}  // namespace alate
