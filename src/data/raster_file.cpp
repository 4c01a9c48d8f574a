#include "data/raster_file.hpp"

#include <filesystem>
#include <system_error>

#include "data/gdal_setup.hpp"

namespace alate {

namespace {

constexpr std::string_view kZipPrefix = "/vsizip/";

/// A path inside a zip file, with no other virtual file system nested in it.
bool is_zip_path(std::string_view file) {
  if (!file.starts_with(kZipPrefix)) return false;
  const std::string_view rest = file.substr(kZipPrefix.size());
  return !rest.starts_with("vsi") && rest.find("/vsi") == std::string_view::npos &&
         rest.find('{') == std::string_view::npos;
}

/// Why the file cannot be a raster, before GDAL looks at it; empty if it may be one.
std::string problem_before_opening(const std::string& file) {
  if (file.starts_with("/vsi")) return is_zip_path(file) ? "" : "only plain files and /vsizip/ paths are read";
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return "no such file";
  if (!std::filesystem::is_regular_file(status)) return "is not a plain file";
  const auto size = std::filesystem::file_size(file, error);
  if (error) return "cannot be read";
  if (size == 0) return "is empty";
  return "";
}

}  // namespace

GDALDatasetUniquePtr open_raster(const std::string& file, std::string& problem) {
  problem = problem_before_opening(file);
  if (!problem.empty()) return nullptr;
  // GeoTIFF 1.0 files keep quiet about their vertical datum unless asked.
  CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", "YES");
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, kRasterDrivers.data(), nullptr, nullptr));
  CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", nullptr);
  if (!dataset) problem = "is not a raster that can be read (GeoTIFF, ESRI ASCII grid, SRTM HGT or DTED)";
  return dataset;
}

}  // namespace alate
