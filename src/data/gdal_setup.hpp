// GDAL as alate uses it: four raster drivers, no network, no words on stderr.
#pragma once

#include <cpl_error.h>

#include <array>

namespace alate {

/// Drivers that a raster may be opened with, for GDALOpenEx; ends in nullptr.
inline constexpr std::array<const char*, 5> kRasterDrivers{"GTiff", "AAIGrid", "SRTMHGT", "DTED", nullptr};

/// Registers those drivers once (registering all costs many times more) and turns PROJ's network off.
void prepare_gdal();

/// While it lives, GDAL's errors on this thread are kept for CPLGetLastErrorMsg and not printed.
class QuietGdal {
 public:
  QuietGdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

}  // namespace alate
