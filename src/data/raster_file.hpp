// Opening a raster that somebody else named.
#pragma once

#include <gdal_priv.h>

#include <string>

namespace alate {

/// Opens a plain file, or one inside a plain zip file (`/vsizip/...`), with an allowed driver. On failure
/// `problem` says why in a few words. Call prepare_gdal first.
GDALDatasetUniquePtr open_raster(const std::string& file, std::string& problem);

}  // namespace alate
