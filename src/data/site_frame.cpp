#include "data/site_frame.hpp"

#include <fmt/core.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <stdexcept>

namespace alate {

namespace {

constexpr double kMostScaleError = 0.01;

std::optional<GeoPoint> geo_of(const PlaceSpec& place) {
  if (!place.lat_deg || !place.lon_deg) return std::nullopt;
  return GeoPoint{*place.lat_deg, *place.lon_deg};
}

/// Half way along the geodesic, so that the date line is no border.
GeoPoint midpoint(const GeoPoint& a, const GeoPoint& b) {
  const auto& earth = GeographicLib::Geodesic::WGS84();
  double distance = 0;
  double heading = 0;
  double arrival = 0;
  earth.Inverse(a.lat_deg, a.lon_deg, b.lat_deg, b.lon_deg, distance, heading, arrival);
  GeoPoint middle;
  earth.Direct(a.lat_deg, a.lon_deg, heading, distance / 2, middle.lat_deg, middle.lon_deg);
  return middle;
}

Frame automatic(const Scenario& scenario) {
  const auto start = geo_of(scenario.start.place);
  const auto goal = geo_of(scenario.goal.place);
  if (!start && !goal) return Frame::local();
  return Frame::utm(start && goal ? midpoint(*start, *goal) : start ? *start : *goal);
}

}  // namespace

std::optional<Frame> choose_frame(const Scenario& scenario, SiteFaults& faults) {
  const FrameSpec& spec = scenario.frame;
  if (spec.local) return Frame::local();
  const std::string field = spec.origin ? "frame.origin" : "frame.crs";
  try {
    if (spec.origin) return Frame::at_origin(*spec.origin);
    return spec.crs == "auto" ? automatic(scenario) : Frame::from_crs(spec.crs);
  } catch (const std::exception& error) {
    faults.add({.field = field, .value = spec.origin ? "" : spec.crs, .message = error.what()});
    return std::nullopt;
  }
}

void judge_scale(const Frame& frame, const Vec2& start, SiteFaults& faults) {
  const double scale = frame.scale_at(start);
  if (std::abs(scale - 1) <= kMostScaleError) return;
  faults.add({.field = "frame.crs",
              .value = frame.name(),
              .limit = "0.99 to 1.01",
              .unit = "frame metres per metre",
              .message = fmt::format("a metre on the ground at the start is {:.4f} m in this frame", scale)});
}

}  // namespace alate
