#include "plan/place_name.hpp"

#include <fmt/core.h>

namespace alate {

std::string place_name(const Site& site, const Vec2& xy) {
  if (const auto geo = site.frame.to_geo(xy))
    return fmt::format("latitude {:.5f}, longitude {:.5f}", geo->lat_deg, geo->lon_deg);
  return fmt::format("x {:.1f} m, y {:.1f} m", xy.x(), xy.y());
}

}  // namespace alate
