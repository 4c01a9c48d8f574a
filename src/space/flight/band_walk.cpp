#include "space/flight/band_walk.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// For rounding, and for bends of the profile that come too close to an end to be flown as legs.
constexpr double kSpareHeight_m = 0.005;

/// Mission files hold corners around the arcs, to a millimetre: they must still have room for the vehicle's circle.
constexpr double kSpareRadius = 1.002;

/// So with the slopes of their legs, some of which are a decimetre long.
constexpr double kSpareSlope = 0.9998;

double slope(const std::optional<double>& limit_rad) {
  return limit_rad && *limit_rad < kPi / 2 ? kSpareSlope * std::tan(*limit_rad)
                                           : std::numeric_limits<double>::infinity();
}

/// The greatest slope of the ground anywhere.
double steepness(const HeightRaster& raster) {
  float most = 0;
  // What is no number, beside a void, is never more.
  const auto look = [&](const float* from, const float* to, int count) {
    float rise = 0;
    for (int i = 0; i < count; ++i) rise = std::abs(to[i] - from[i]) > rise ? std::abs(to[i] - from[i]) : rise;
    most = std::max(most, rise);
  };
  for (int row = 0; row < raster.rows; ++row) {
    const float* posts = raster.posts.data() + static_cast<std::ptrdiff_t>(row) * raster.columns;
    look(posts, posts + 1, raster.columns - 1);
    if (row + 1 < raster.rows) look(posts, posts + raster.columns, raster.columns);
  }
  constexpr double kRounding = 1 + 1e-6;
  return std::numbers::sqrt2 * kRounding * double{most};
}

}  // namespace

BandWalk::BandWalk(const World& world)
    : world_(world),
      raster_(std::get_if<HeightRaster>(&world.site().ground)),
      peaks_(std::get_if<PeakGround>(&world.site().ground)),
      radius_m_(kSpareRadius * *world.site().vehicle.turn_radius_m),
      slopes_{slope(world.site().vehicle.climb_rad), slope(world.site().vehicle.descent_rad)} {
  const Site& site = world.site();
  most_chord_m_ = 2 * radius_m_ * std::acos(std::max(-1.0, 1 - kSagitta_m / radius_m_));
  if (peaks_ != nullptr) arc_margin_m_ = 2 * kSagitta_m * peaks_->steepness();
  // Posts may lie closer along one axis than the mean tells: twice as close is more than any raster on Earth has.
  if (raster_ != nullptr) {
    arc_margin_posts_ = 2 * kSagitta_m * 2 / raster_->cell_m;
    arc_margin_m_ = arc_margin_posts_ * steepness(*raster_);
  }
  clearance_m_ = site.band.clearance_m + kSpareHeight_m;
  if (peaks_ != nullptr) peak_slope_ = peaks_->steepness();
  if (site.band.ceiling_agl_m && site.has_ground()) ceiling_agl_m_ = *site.band.ceiling_agl_m - kSpareHeight_m;
  if (site.band.ceiling_amsl_m) ceiling_amsl_m_ = *site.band.ceiling_amsl_m;
  for (const Threat& threat : site.threats) {
    if (threat.core_m <= 0) continue;
    const bool sphere = threat.shape == Threat::Shape::sphere;
    cores_.push_back({.center = threat.center.head<2>(),
                      .reach_m = threat.core_m + 2 * kSagitta_m,
                      .top_m = sphere ? threat.center.z() : threat.top_m + kSpareHeight_m,
                      .sphere = sphere});
  }
}

std::pair<double, double> BandWalk::open_at(const Vec2& place) const {
  constexpr double kRounding_m = 1e-6;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (raster_ == nullptr && peaks_ == nullptr) return {-kInfinity, ceiling_amsl_m_};
  const auto ground = world_.height(place);
  if (!ground || std::isnan(*ground)) return {kInfinity, -kInfinity};
  return {*ground + clearance_m_ - kRounding_m, std::min(ceiling_amsl_m_, *ground + ceiling_agl_m_ + kRounding_m)};
}

bool BandWalk::is_near_core(const PlanarPiece& piece) const {
  return std::ranges::any_of(cores_,
                             [&](const Core& core) { return piece.may_come_within(core.reach_m, core.center); });
}

bool BandWalk::is_known_beside(const Vec2& from, const Vec2& to) const {
  const Vec2 beside = Vec2::Constant(arc_margin_posts_);
  const Vec2 low = from.cwiseMin(to) - beside;
  const Vec2 high = from.cwiseMax(to) + beside;
  if (!raster_->covers(low) || !raster_->covers(high)) return false;
  if (raster_->voids == 0) return true;
  const int last_column = std::min(static_cast<int>(high.x()) + 1, raster_->columns - 1);
  const int last_row = std::min(static_cast<int>(high.y()) + 1, raster_->rows - 1);
  for (int row = static_cast<int>(low.y()); row <= last_row; ++row)
    for (int column = static_cast<int>(low.x()); column <= last_column; ++column)
      if (std::isnan(raster_->post(column, row))) return false;
  return true;
}

/// Over the piece a core is as high as where the piece comes closest to its middle.
void BandWalk::close_cores(const Chord& chord, const GroundSpan& span, BandPiece& band) const {
  const Vec2 way = chord.to - chord.from;
  const Vec2 a = chord.from + span.t_from * way;
  const Vec2 b = chord.from + span.t_to * way;
  for (const Core& core : cores_) {
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0 ? std::clamp((core.center - a).dot(b - a) / squared, 0.0, 1.0) : 0;
    const double beyond = core.reach_m * core.reach_m - (a + t * (b - a) - core.center).squaredNorm();
    if (beyond <= 0) continue;
    const double top = core.top_m + (core.sphere ? std::sqrt(beyond) : 0);
    band.floor_from = std::max(band.floor_from, top);
    band.floor_to = std::max(band.floor_to, top);
  }
}

}  // namespace alate
