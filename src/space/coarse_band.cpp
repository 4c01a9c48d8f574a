#include "space/coarse_band.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace alate {

namespace {

Box2 area_of(const Site& site) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return raster->area;
  return std::get<PeakGround>(site.ground).area;
}

}  // namespace

CoarseBand::CoarseBand(const World& world) : area_(area_of(world.site())) {
  const Vec2 extent = area_.max - area_.min;
  cell_m_ = std::sqrt(extent.x() * extent.y() / kCells);
  columns_ = std::max(1, static_cast<int>(std::ceil(extent.x() / cell_m_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(extent.y() / cell_m_)));
  floor_.assign(size(), kInfinity);
  ceiling_.assign(size(), -kInfinity);
  threat_.assign(size() * kLayers, 0);
  for (std::size_t cell = 0; cell < size(); ++cell) sample_ground(world, cell);

  const Mission& mission = world.site().mission;
  open_top_m_ = std::max(mission.start.z(), mission.goal.z());
  for (const double floor : floor_)
    if (floor < kInfinity) open_top_m_ = std::max(open_top_m_, floor);
  for (std::size_t cell = 0; cell < size(); ++cell) {
    ceiling_[cell] = std::min(ceiling_[cell], open_top_m_ + cell_m_);
    if (!blocked(cell)) sample_threat(world, cell);
  }
}

Vec2 CoarseBand::center(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(columns_);
  return area_.min +
         cell_m_ * Vec2(static_cast<double>(cell % columns) + 0.5, static_cast<double>(cell / columns) + 0.5);
}

void CoarseBand::sample_ground(const World& world, std::size_t cell) {
  const Band& band = world.site().band;
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
  for (int layer = 0; layer < kLayers; ++layer) {
    const double z = altitude(cell, layer);
    const Vec3 here(middle.x(), middle.y(), z);
    const Segment leg{here - Vec3(half, 0, 0), here + Vec3(half, 0, 0)};
    threat_[cell * kLayers + static_cast<std::size_t>(layer)] =
        world.enters_core({here, here}) ? kInfinity : world.exposure(leg) / (2 * half);
  }
}

}  // namespace alate
