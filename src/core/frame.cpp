#include "alate/core/frame.hpp"

#include <fmt/core.h>
#include <proj.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <mutex>
#include <stdexcept>

namespace alate {

namespace {

struct ContextDeleter {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct PjDeleter {
  void operator()(PJ* pj) const { proj_destroy(pj); }
};
using ContextPtr = std::unique_ptr<PJ_CONTEXT, ContextDeleter>;
using PjPtr = std::unique_ptr<PJ, PjDeleter>;

ContextPtr make_context() {
  ContextPtr context(proj_context_create());
  proj_context_set_enable_network(context.get(), 0);
  proj_log_level(context.get(), PJ_LOG_NONE);
  return context;
}

/// Are both horizontal axes of this CRS in metres?
bool is_metric(PJ_CONTEXT* context, const PJ* crs) {
  const PjPtr system(proj_crs_get_coordinate_system(context, crs));
  if (!system) return false;
  for (int axis = 0; axis < 2; ++axis) {
    double metres = 0;
    const char* unit = nullptr;
    if (proj_cs_get_axis_info(context, system.get(), axis, nullptr, nullptr, nullptr, &metres, &unit, nullptr,
                              nullptr) == 0)
      return false;
    if (metres != 1.0 || unit == nullptr || std::string(unit) == "degree") return false;
  }
  return true;
}

void require_projected(PJ_CONTEXT* context, const std::string& name) {
  const PjPtr crs(proj_create(context, name.c_str()));
  if (!crs || proj_is_crs(crs.get()) == 0) throw std::invalid_argument("PROJ does not know this coordinate system");
  PjPtr base;
  const PJ* judged = crs.get();
  if (proj_get_type(judged) == PJ_TYPE_COMPOUND_CRS) {
    base.reset(proj_crs_get_sub_crs(context, judged, 0));
    judged = base.get();
  } else if (proj_get_type(judged) == PJ_TYPE_BOUND_CRS) {
    base.reset(proj_get_source_crs(context, judged));
    judged = base.get();
  }
  if (judged == nullptr || proj_get_type(judged) != PJ_TYPE_PROJECTED_CRS || !is_metric(context, judged))
    throw std::invalid_argument("is not a projected coordinate system in metres");
}

}  // namespace

/// PROJ objects are not safe to share between threads, so every conversion holds the lock.
struct Frame::Projection {
  std::string name;
  ContextPtr context;
  PjPtr transform;  ///< Longitude, latitude in degrees -> x, y; empty in a local frame.
  mutable std::mutex mutex;

  std::optional<Vec2> convert(PJ_DIRECTION direction, double a, double b) const {
    const std::lock_guard lock(mutex);
    const PJ_COORD out = proj_trans(transform.get(), direction, proj_coord(a, b, 0, 0));
    if (!std::isfinite(out.xy.x) || !std::isfinite(out.xy.y)) return std::nullopt;
    return Vec2{out.xy.x, out.xy.y};
  }
};

Frame::Frame(std::shared_ptr<const Projection> projection) : projection_(std::move(projection)) {}

Frame Frame::local() {
  auto projection = std::make_shared<Projection>();
  projection->name = "local";
  return Frame(projection);
}

Frame Frame::utm(const GeoPoint& point) {
  int zone = 0;
  bool north = true;
  double x = 0;
  double y = 0;
  GeographicLib::UTMUPS::Forward(point.lat_deg, point.lon_deg, zone, north, x, y);
  if (zone == GeographicLib::UTMUPS::UPS) return from_crs(north ? "EPSG:32661" : "EPSG:32761");
  return from_crs(fmt::format("EPSG:{}", (north ? 32600 : 32700) + zone));
}

Frame Frame::at_origin(const GeoPoint& origin) {
  return from_crs(fmt::format("+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +type=crs",
                              origin.lat_deg, origin.lon_deg));
}

Frame Frame::from_crs(const std::string& crs) {
  auto projection = std::make_shared<Projection>();
  projection->name = crs;
  projection->context = make_context();
  PJ_CONTEXT* context = projection->context.get();
  require_projected(context, crs);
  const PjPtr raw(proj_create_crs_to_crs(context, "EPSG:4326", crs.c_str(), nullptr));
  if (raw) projection->transform.reset(proj_normalize_for_visualization(context, raw.get()));
  if (!projection->transform) throw std::invalid_argument("PROJ has no way from WGS 84 to this coordinate system");
  return Frame(projection);
}

bool Frame::is_local() const { return projection_->transform == nullptr; }

const std::string& Frame::name() const { return projection_->name; }

std::optional<GeoPoint> Frame::to_geo(const Vec2& xy) const {
  if (is_local()) return std::nullopt;
  const auto lon_lat = projection_->convert(PJ_INV, xy.x(), xy.y());
  if (!lon_lat) return std::nullopt;
  return GeoPoint{lon_lat->y(), lon_lat->x()};
}

std::optional<Vec2> Frame::from_geo(const GeoPoint& point) const {
  if (is_local()) return std::nullopt;
  return projection_->convert(PJ_FWD, point.lon_deg, point.lat_deg);
}

double Frame::scale_at(const Vec2& xy) const {
  constexpr double kStep = 100;
  const auto here = to_geo(xy);
  const auto there = to_geo(xy + Vec2{kStep, 0});
  if (!here || !there) return 1;
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(here->lat_deg, here->lon_deg, there->lat_deg, there->lon_deg, metres);
  return kStep / metres;
}

}  // namespace alate
