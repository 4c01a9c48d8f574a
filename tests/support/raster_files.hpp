// Small rasters written by the tests themselves.
#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alate::test {

struct RasterRecipe {
  int columns = 4;
  int rows = 3;
  std::vector<float> heights;  ///< Row-major from the north-west; empty: 100 everywhere.
  std::optional<std::array<double, 6>> geotransform = std::array<double, 6>{500000, 30, 0, 4000090, 0, -30};
  std::string crs = "EPSG:32616";  ///< Empty: none.
  bool pixel_is_point = false;
  std::optional<double> no_data;
  std::string unit;
  double scale = 1;
  double offset = 0;
  GDALDataType type = GDT_Float32;
};

/// A folder of this test process, made on first use.
inline std::filesystem::path scratch_folder() {
  const auto folder = std::filesystem::path(ALATE_BINARY_DIR) / "scratch" / std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  return folder;
}

/// Writes a GeoTIFF and returns its path.
inline std::string write_raster(const std::string& name, const RasterRecipe& recipe) {
  GDALAllRegister();
  const std::string file = (scratch_folder() / name).string();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const GDALDatasetUniquePtr dataset(
      driver->Create(file.c_str(), recipe.columns, recipe.rows, 1, recipe.type, nullptr));
  if (recipe.pixel_is_point) dataset->SetMetadataItem("AREA_OR_POINT", "Point");
  auto geotransform = recipe.geotransform.value_or(std::array<double, 6>{});
  if (recipe.geotransform) dataset->SetGeoTransform(geotransform.data());
  OGRSpatialReference crs;
  if (!recipe.crs.empty()) {
    crs.SetFromUserInput(recipe.crs.c_str());
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    dataset->SetSpatialRef(&crs);
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (recipe.no_data) band.SetNoDataValue(*recipe.no_data);
  if (!recipe.unit.empty()) band.SetUnitType(recipe.unit.c_str());
  if (recipe.scale != 1) band.SetScale(recipe.scale);
  if (recipe.offset != 0) band.SetOffset(recipe.offset);
  std::vector<float> heights = recipe.heights;
  heights.resize(static_cast<std::size_t>(recipe.columns) * static_cast<std::size_t>(recipe.rows), 100);
  const CPLErr error = band.RasterIO(GF_Write, 0, 0, recipe.columns, recipe.rows, heights.data(), recipe.columns,
                                     recipe.rows, GDT_Float32, 0, 0, nullptr);
  return error == CE_None ? file : "";
}

}  // namespace alate::test
