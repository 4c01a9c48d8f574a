#include "data/raster_writer.hpp"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "data/gdal_setup.hpp"

namespace alate {

namespace {

/// A file in memory, gone with this.
class MemoryFile {
 public:
  MemoryFile() : name_("/vsimem/alate-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".tif") {}
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& name() const { return name_; }
  std::string content() const {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    return bytes == nullptr ? std::string() : std::string(bytes, bytes + size);
  }

 private:
  std::string name_;
};

/// False if GDAL cannot.
bool write(const DrawnTerrain& terrain, const std::string& file) {
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "2");
  options.SetNameValue("ZLEVEL", "9");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const GDALDatasetUniquePtr dataset(
      driver->Create(file.c_str(), terrain.side, terrain.side, 1, GDT_Int16, options.List()));
  if (!dataset) return false;
  // Corners of cells around the posts.
  const double edge = kDrawnCell_m / 2;
  std::array<double, 6> corner{-edge, kDrawnCell_m, 0, terrain.width_m() + edge, 0, -kDrawnCell_m};
  dataset->SetGeoTransform(corner.data());
  std::vector<float> row(static_cast<std::size_t>(terrain.side));
  for (int i = 0; i < terrain.side; ++i) {
    const auto from = terrain.posts.begin() + static_cast<std::ptrdiff_t>(i) * terrain.side;
    row.assign(from, from + terrain.side);
    if (dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, i, terrain.side, 1, row.data(), terrain.side, 1, GDT_Float32,
                                            0, 0, nullptr) != CE_None)
      return false;
  }
  dataset->FlushCache(true);
  return CPLGetLastErrorType() < CE_Failure;
}

}  // namespace

std::string geotiff(const DrawnTerrain& terrain) {
  prepare_gdal();
  const QuietGdal quiet;
  const MemoryFile file;
  if (!write(terrain, file.name())) throw std::runtime_error(CPLGetLastErrorMsg());
  return file.content();
}

}  // namespace alate
