#include "alate/world/world.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "world/peak_clearance.hpp"
#include "world/raster_ground.hpp"
#include "world/threat_field.hpp"

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A place exactly at a limit, which rounding put a hair beyond it, is still allowed.
constexpr double kForgiven_m = 1e-6;

}  // namespace

struct World::Data {
  explicit Data(Site given) : site(std::move(given)) {
    if (const auto* heights = std::get_if<HeightRaster>(&site.ground)) raster.emplace(*heights);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

  const PeakGround* peaks() const { return std::get_if<PeakGround>(&site.ground); }

  bool within_band(const Segment& leg) const {
    const double floor = site.band.clearance_m - kForgiven_m;
    const double roof = site.band.ceiling_agl_m ? *site.band.ceiling_agl_m + kForgiven_m : kInfinity;
    if (raster) return raster->within(leg, floor, roof);
    return peaks() == nullptr || within(*peaks(), leg, floor, roof);
  }

  Site site;
  std::optional<RasterGround> raster;
};

World::World(Site site) : data_(std::make_shared<const Data>(std::move(site))) {}

const Site& World::site() const { return data_->site; }

std::optional<double> World::height(const Vec2& xy) const {
  if (!data_->site.has_ground()) return 0;
  return data_->site.ground_height(xy);
}

double World::clearance(const Segment& leg) const {
  if (data_->raster) return data_->raster->clearance(leg);
  if (const PeakGround* peaks = data_->peaks()) return alate::clearance(*peaks, leg);
  return kInfinity;
}

bool World::is_free(const Segment& leg) const {
  const auto& ceiling = data_->site.band.ceiling_amsl_m;
  if (ceiling && std::max(leg.a.z(), leg.b.z()) > *ceiling + kForgiven_m) return false;
  return data_->within_band(leg) && !enters_core(leg);
}

double World::exposure(const Segment& leg) const {
  double sum = 0;
  for (const Threat& threat : data_->site.threats) sum += alate::exposure(threat, leg);
  return sum;
}

bool World::enters_core(const Segment& leg) const {
  return std::ranges::any_of(data_->site.threats,
                             [&](const Threat& threat) { return alate::enters_core(threat, leg); });
}

}  // namespace alate
