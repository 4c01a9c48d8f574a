#include <fmt/core.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "alate/data/height_raster.hpp"
#include "data/gdal_setup.hpp"
#include "data/ground_map.hpp"
#include "data/limits.hpp"
#include "data/raster_file.hpp"

namespace alate {

namespace {

/// Adds faults about one raster file.
class Complaints {
 public:
  Complaints(const std::string& file, std::vector<Fault>& faults)
      : file_(file), faults_(faults), before_(faults.size()) {}

  void add(std::string message, std::string limit = {}) {
    faults_.push_back(
        {.field = "terrain.dem", .value = file_, .limit = std::move(limit), .message = std::move(message)});
  }
  bool any() const { return faults_.size() > before_; }

 private:
  const std::string& file_;
  std::vector<Fault>& faults_;
  std::size_t before_;
};

bool is_real(GDALDataType type) { return type != GDT_Unknown && GDALDataTypeIsComplex(type) == 0; }

/// Metres per unit of the heights, by what band or CRS say; nothing for a unit that is no length we know.
std::optional<double> metres_per_unit(const std::string& unit, const OGRSpatialReference& crs) {
  if (unit.empty()) return crs.IsCompound() != 0 ? crs.GetTargetLinearUnits("VERT_CS") : 1.0;
  if (unit == "m" || unit == "metre" || unit == "meter" || unit == "metres" || unit == "meters") return 1.0;
  if (unit == "ft" || unit == "foot" || unit == "feet") return 0.3048;
  if (unit == "us-ft" || unit == "US survey foot" || unit == "ftUS") return 1200.0 / 3937.0;
  return std::nullopt;
}

void judge_shape(GDALDataset& dataset, Complaints& complaints) {
  const auto cells = std::int64_t{dataset.GetRasterXSize()} * dataset.GetRasterYSize();
  if (cells > kMaxRasterCells)
    complaints.add(fmt::format("has {} cells, too many to hold", cells),
                   fmt::format("{} cells at most", kMaxRasterCells));
  if (dataset.GetRasterXSize() < 2 || dataset.GetRasterYSize() < 2)
    complaints.add(fmt::format("has {} x {} posts", dataset.GetRasterXSize(), dataset.GetRasterYSize()),
                   "2 x 2 posts at least");
}

void judge_band(GDALDataset& dataset, Complaints& complaints) {
  if (dataset.GetRasterCount() == 0) return complaints.add("has no band of heights");
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  if (!is_real(band.GetRasterDataType())) complaints.add("holds complex numbers and no heights");
  if (band.GetColorTable() != nullptr) complaints.add("is a picture with a colour table and holds no heights");
  const double scale = band.GetScale();
  if (!std::isfinite(scale) || scale == 0 || !std::isfinite(band.GetOffset()))
    complaints.add("has a scale or an offset that is no number");
  const auto* crs = dataset.GetSpatialRef();
  if (!metres_per_unit(band.GetUnitType(), crs != nullptr ? *crs : OGRSpatialReference()))
    complaints.add(fmt::format("gives heights in '{}'", band.GetUnitType()), "metres or feet");
}

void judge_crs(const OGRSpatialReference* crs, const Frame& frame, Complaints& complaints) {
  if (crs == nullptr || crs->IsEmpty()) {
    if (!frame.is_local()) complaints.add("does not say its coordinate system");
    return;
  }
  if (frame.is_local() && (crs->IsProjected() == 0 || crs->GetLinearUnits() != 1.0))
    return complaints.add("is not in metres, as a local frame needs it; choose another frame");
  if (crs->IsGeographic() == 0 && crs->IsProjected() == 0)
    return complaints.add("has a coordinate system with no place on Earth");
  if (crs->IsCompound() == 0 && crs->GetAxesCount() == 3)
    complaints.add("gives heights above the ellipsoid", "heights above mean sea level");
}

/// Where the posts lie; empty geotransform if the file does not say.
RasterGrid grid_of(GDALDataset& dataset, Complaints& complaints) {
  RasterGrid grid;
  grid.columns = dataset.GetRasterXSize();
  grid.rows = dataset.GetRasterYSize();
  const auto& g = grid.geotransform;
  if (dataset.GetGeoTransform(grid.geotransform.data()) != CE_None)
    complaints.add("does not say where its cells lie (no geotransform)");
  else if (!std::ranges::all_of(g, [](double x) { return std::isfinite(x); }) || g[1] * g[5] - g[2] * g[4] == 0)
    complaints.add("has a geotransform that maps all cells to one line");
  if (const auto* crs = dataset.GetSpatialRef()) {
    grid.crs = *crs;
    if (grid.crs.IsCompound() != 0) grid.crs.StripVertical();
    grid.crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  }
  return grid;
}

std::string datum_of(GDALDataset& dataset) {
  const auto* crs = dataset.GetSpatialRef();
  if (crs != nullptr && crs->IsCompound() != 0) {
    if (const char* name = crs->GetAttrValue("COMPD_CS|VERT_CS")) return name;
  }
  const char* tag = dataset.GetMetadataItem("DTED_VerticalDatum");
  if (tag == nullptr) return "not stated (taken as mean sea level)";
  const std::string code = tag;
  return code == "E96" ? "EGM96 mean sea level" : code == "MSL" ? "mean sea level" : code;
}

/// Turns what is no height into NaN, brings the rest to metres and counts the voids.
std::size_t clean(std::vector<float>& posts, GDALRasterBand& band, double to_metres) {
  int has_no_data = 0;
  const double no_data = band.GetNoDataValue(&has_no_data);
  const auto marker = static_cast<float>(no_data);
  const double scale = band.GetScale() * to_metres;
  const double offset = band.GetOffset() * to_metres;
  std::size_t voids = 0;
  for (float& post : posts) {
    const double height = double{post} * scale + offset;
    const bool marked = has_no_data != 0 && post == marker;
    const bool known = !marked && height >= kLowestGround && height <= kHighestGround;
    post = known ? static_cast<float>(height) : std::numeric_limits<float>::quiet_NaN();
    if (!known) ++voids;
  }
  return voids;
}

/// Some rows at a time, so that GDAL does not keep a second copy of a large raster among its blocks.
bool read_posts(GDALRasterBand& band, HeightRaster& raster) {
  constexpr int kRows = 512;
  raster.posts.resize(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  int block_columns = 0;
  int block_rows = 0;
  band.GetBlockSize(&block_columns, &block_rows);
  const int step = std::max(1, kRows / block_rows) * block_rows;
  CPLErrorReset();
  for (int row = 0; row < raster.rows; row += std::min(step, raster.rows - row)) {
    const int rows = std::min(step, raster.rows - row);
    float* posts = &raster.posts[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns)];
    const CPLErr error =
        band.RasterIO(GF_Read, 0, row, raster.columns, rows, posts, raster.columns, rows, GDT_Float32, 0, 0, nullptr);
    if (error != CE_None || CPLGetLastErrorType() >= CE_Failure) return false;
    band.FlushCache(false);
  }
  return true;
}

}  // namespace

std::optional<HeightRaster> read_height_raster(const std::string& file, const Frame& frame,
                                               std::vector<Fault>& faults) {
  prepare_gdal();
  const QuietGdal quiet;
  Complaints complaints(file, faults);
  std::string problem;
  const auto dataset = open_raster(file, problem);
  if (!dataset) {
    complaints.add(problem);
    return std::nullopt;
  }
  const RasterGrid grid = grid_of(*dataset, complaints);
  judge_shape(*dataset, complaints);
  judge_band(*dataset, complaints);
  judge_crs(dataset->GetSpatialRef(), frame, complaints);
  if (complaints.any()) return std::nullopt;

  HeightRaster raster;
  raster.columns = grid.columns;
  raster.rows = grid.rows;
  raster.name = std::filesystem::path(file).filename().string();
  raster.crs = grid.crs.IsEmpty() ? "not stated" : grid.crs.GetName();
  raster.datum = datum_of(*dataset);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (!read_posts(band, raster)) {
    complaints.add(fmt::format("is damaged or cut short: {}", CPLGetLastErrorMsg()));
    return std::nullopt;
  }
  const auto* crs = dataset->GetSpatialRef();
  const double to_metres = *metres_per_unit(band.GetUnitType(), crs != nullptr ? *crs : OGRSpatialReference());
  raster.voids = clean(raster.posts, band, to_metres);

  auto ground = map_ground(grid, frame);
  if (!ground) {
    complaints.add("reaches too far to be brought into the frame; cut it to the region of the flight");
    return std::nullopt;
  }
  raster.map = std::move(ground->map);
  raster.area = ground->area;
  raster.cell_m = ground->cell_m;
  return raster;
}

}  // namespace alate
