// The one metric frame that a scenario is planned in, and its way to and from WGS 84.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "alate/core/geometry.hpp"

namespace alate {

/// WGS 84 latitude and longitude, degrees.
struct GeoPoint {
  double lat_deg = 0;
  double lon_deg = 0;

  bool operator==(const GeoPoint&) const = default;
};

/// A metric frame. Copies share one immutable projection; conversions may be called from any thread.
/// Heights are not touched: they are metres above mean sea level in every frame.
class Frame {
 public:
  /// A frame of plain metres with no place on Earth.
  static Frame local();
  /// UTM zone that holds `point`.
  static Frame utm(const GeoPoint& point);
  /// Transverse Mercator of scale 1 at `origin`, which becomes (0, 0).
  static Frame at_origin(const GeoPoint& origin);
  /// Any projected CRS that PROJ knows ("EPSG:21781", WKT). Throws std::invalid_argument with a plain
  /// sentence for an unknown CRS, or one whose axes are not metres.
  static Frame from_crs(const std::string& crs);

  bool is_local() const;
  /// "local", or the CRS in a form that from_crs reads again.
  const std::string& name() const;

  /// Nothing in a local frame, or where the projection is undefined.
  std::optional<GeoPoint> to_geo(const Vec2& xy) const;
  std::optional<Vec2> from_geo(const GeoPoint& point) const;

  /// Metres of this frame per metre on the ground, at `xy`: 0.9996-1.001 in UTM, 1.5 in Web Mercator at 48 N.
  /// 1 in a local frame.
  double scale_at(const Vec2& xy) const;

 private:
  struct Projection;
  explicit Frame(std::shared_ptr<const Projection> projection);
  std::shared_ptr<const Projection> projection_;
};

}  // namespace alate
