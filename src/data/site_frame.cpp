#include "data/site_frame.hpp"

#include <fmt/core.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "data/raster_extent.hpp"

namespace alate {

namespace {

constexpr double kMostScaleError = 0.01;

/// Where an end of the flight is given on Earth.
std::optional<GeoPoint> geo_of(const PlaceSpec& place, const std::optional<GivenPoint>& given) {
  if (given && given->geographic) return GeoPoint{given->point.position.x(), given->point.position.y()};
  if (!place.lat_deg || !place.lon_deg) return std::nullopt;
  return GeoPoint{*place.lat_deg, *place.lon_deg};
}

/// Without a frame, metres and places on Earth cannot stand side by side.
bool is_mixed(const Scenario& scenario, const GivenPoints& points, bool on_earth) {
  const auto metric = [](const PlaceSpec& place) { return place.position_m.has_value(); };
  const auto differs = [&](const auto& given) { return given.geographic != on_earth; };
  const auto end_differs = [&](const auto& end) { return end && differs(*end); };
  return (on_earth && (metric(scenario.start.place) || metric(scenario.goal.place))) ||
         std::ranges::any_of(points.points(), differs) || end_differs(points.start()) || end_differs(points.end());
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

/// A grid is cut from the whole raster, so that its cells do not change with start and goal. Where the raster has no
/// place on Earth any frame will do: its reader says what is wrong.
Frame frame_of_grid(const std::string& dem) {
  const auto extent = raster_extent(dem);
  return Frame::utm(extent ? extent->middle : GeoPoint{});
}

Frame automatic(const Scenario& scenario, const GivenPoints& points) {
  if (scenario.grid) return frame_of_grid(scenario.grid->dem);
  const auto start = geo_of(scenario.start.place, points.start());
  const auto goal = geo_of(scenario.goal.place, points.end());
  if (is_mixed(scenario, points, start || goal))
    throw std::invalid_argument("some places are in metres and some in lat and lon; name the frame of the metres");
  if (!start && !goal) return Frame::local();
  return Frame::utm(start && goal ? midpoint(*start, *goal) : start ? *start : *goal);
}

}  // namespace

std::optional<Frame> choose_frame(const Scenario& scenario, const GivenPoints& points, SiteFaults& faults) {
  const FrameSpec& spec = scenario.frame;
  if (spec.local || (scenario.grid && scenario.grid->dem.empty())) return Frame::local();
  const std::string field = spec.origin ? "frame.origin" : "frame.crs";
  try {
    if (spec.origin) return Frame::at_origin(*spec.origin);
    return spec.crs == "auto" ? automatic(scenario, points) : Frame::from_crs(spec.crs);
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
