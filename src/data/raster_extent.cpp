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
  const double right = dataset->GetRasterXSize() - 0.5;
  const double bottom = dataset->GetRasterYSize() - 0.5;
  constexpr std::size_t kMiddle = 4;  // after the four corners
  const std::array<double, 5> columns{0.5, right, 0.5, right, (right + 0.5) / 2};
  const std::array<double, 5> rows{0.5, 0.5, bottom, bottom, (bottom + 0.5) / 2};
  std::array<double, 5> x{};
  std::array<double, 5> y{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    x.at(i) = g[0] + columns.at(i) * g[1] + rows.at(i) * g[2];
    y.at(i) = g[3] + columns.at(i) * g[4] + rows.at(i) * g[5];
  }
  if (transform->Transform(x.size(), x.data(), y.data()) == 0) return std::nullopt;
  return GeoBox{.min = {std::ranges::min(y), std::ranges::min(x)},
                .max = {std::ranges::max(y), std::ranges::max(x)},
                .middle = {y[kMiddle], x[kMiddle]}};
}

}  // namespace alate
