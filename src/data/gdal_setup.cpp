#include "data/gdal_setup.hpp"

#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <mutex>

namespace alate {

void prepare_gdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALRegister_GTiff();
    GDALRegister_AAIGrid();
    GDALRegister_SRTMHGT();
    GDALRegister_DTED();
    OSRSetPROJEnableNetwork(0);
  });
}

}  // namespace alate
