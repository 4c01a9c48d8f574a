#include "data/raster_extent.hpp"

#include <fmt/core.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "data/gdal_setup.hpp"
#include "data/raster_file.hpp"

namespace alate {

namespace {

struct TransformDeleter {
  void operator()(OGRCoordinateTransformation* transform) const { OCTDestroyCoordinateTransformation(transform); }
};

}  // namespace

bool GeoBox::contains(const GeoPoint& point) const {
  return point.lat_deg >= min.lat_deg && point.lat_deg <= max.lat_deg && point.lon_deg >= min.lon_deg &&
         point.lon_deg <= max.lon_deg;
}

std::string GeoBox::text() const {
  return fmt::format("lat {:.5f} to {:.5f}, lon {:.5f} to {:.5f}", min.lat_deg, max.lat_deg, min.lon_deg, max.lon_deg);
}

std::optional<GeoBox> raster_extent(const std::string& file) {
  prepare_gdal();
  const QuietGdal quiet;
  std::string problem;
  const auto dataset = open_raster(file, problem);
  std::array<double, 6> g{};
  if (!dataset || dataset->GetSpatialRef() == nullptr || dataset->GetGeoTransform(g.data()) != CE_None)
    return std::nullopt;
  OGRSpatialReference source = *dataset->GetSpatialRef();
  source.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation, TransformDeleter> transform(
      OGRCreateCoordinateTransformation(&source, &wgs84));
  if (!transform) return std::nullopt;
  std::array<double, 4> x{};
  std::array<double, 4> y{};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const double column = corner % 2 == 0 ? 0.5 : dataset->GetRasterXSize() - 0.5;
    const double row = corner < 2 ? 0.5 : dataset->GetRasterYSize() - 0.5;
    x[corner] = g[0] + column * g[1] + row * g[2];
    y[corner] = g[3] + column * g[4] + row * g[5];
  }
  if (transform->Transform(x.size(), x.data(), y.data()) == 0) return std::nullopt;
  return GeoBox{.min = {std::ranges::min(y), std::ranges::min(x)}, .max = {std::ranges::max(y), std::ranges::max(x)}};
}

}  // namespace alate
