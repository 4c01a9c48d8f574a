#!/bin/sh
# Makes jacksboro.tif, the ground of the example, again.
#
# Source: USGS elevations of the Jacksboro fault, Tennessee (SRTM, 3 arc-seconds; public domain), as carried by
# Debian's package python-matplotlib-data (jacksboro_fault_dem.npz). SRTM measured tree tops, not the soil.
# The file's ymin has the wrong sign of the rows in it; its ymax is the true north edge. Row 0 is the north edge.
# The corner coordinates below are the outer edges of the cells; posts lie in the cell centres.
# Needs: python-matplotlib-data, python3 (standard library only), gdal-bin.
set -eu
cd "$(dirname "$0")"
source=${1:-/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A .npy file is a header of known length before little-endian Int16 rows.
python3 -c '
import struct, sys, zipfile
data = zipfile.ZipFile(sys.argv[1]).read("elevation.npy")
header = struct.unpack("<H", data[8:10])[0]
assert b"(344, 403)" in data[:10 + header] and b"<i2" in data[:10 + header]
open(sys.argv[2], "wb").write(data[10 + header:])
' "$source" "$work/heights.raw"

cat > "$work/heights.vrt" <<'VRT'
<VRTDataset rasterXSize="403" rasterYSize="344">
  <VRTRasterBand dataType="Int16" band="1" subClass="VRTRawRasterBand">
    <SourceFilename relativeToVRT="1">heights.raw</SourceFilename>
    <ByteOrder>LSB</ByteOrder>
  </VRTRasterBand>
</VRTDataset>
VRT

# EPSG:4326 with heights above EGM96 mean sea level (EPSG:5773).
gdal_translate -q -of GTiff -a_srs EPSG:4326+5773 -a_ullr -84.413750 36.446250 -84.077917 36.159583 \
  -mo AREA_OR_POINT=Area -mo "TIFFTAG_IMAGEDESCRIPTION=USGS elevations, SRTM 3 arc-seconds, public domain" \
  -co COMPRESS=DEFLATE -co PREDICTOR=2 -co ZLEVEL=9 "$work/heights.vrt" jacksboro.tif
