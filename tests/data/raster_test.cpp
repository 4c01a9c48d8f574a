#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "alate/data/height_raster.hpp"
#include "support/jacksboro.hpp"
#include "support/raster_files.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

using test::RasterRecipe;
using test::write_raster;

HeightRaster read(const std::string& file, const Frame& frame) {
  std::vector<Fault> faults;
  auto raster = read_height_raster(file, frame, faults);
  for (const Fault& fault : faults) ADD_FAILURE() << to_string(fault);
  return raster ? std::move(*raster) : HeightRaster{};
}

/// The messages of all faults of a file that must not be read.
std::string refusal(const std::string& file, const Frame& frame = Frame::from_crs("EPSG:32616")) {
  std::vector<Fault> faults;
  EXPECT_FALSE(read_height_raster(file, frame, faults));
  std::string text;
  for (const Fault& fault : faults) {
    EXPECT_EQ(fault.field, "terrain.dem");
    text += fault.message + "\n";
  }
  return text;
}

std::pair<float, float> range_of(const HeightRaster& raster) {
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (const float post : raster.posts) {
    if (std::isnan(post)) continue;
    low = std::min(low, post);
    high = std::max(high, post);
  }
  return {low, high};
}

void write_text(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

TEST(Raster, PostsLieInCellCentresOfAnAreaRaster) {
  RasterRecipe recipe;
  for (int i = 0; i < 12; ++i) recipe.heights.push_back(static_cast<float>(100 + i));
  const HeightRaster raster = read(write_raster("area.tif", recipe), Frame::from_crs("EPSG:32616"));
  EXPECT_DOUBLE_EQ(*raster.height({500015, 4000075}), 100);
  EXPECT_DOUBLE_EQ(*raster.height({500015 + 90, 4000015}), 111);
  EXPECT_DOUBLE_EQ(*raster.height({500030, 4000075}), 100.5);
  EXPECT_FALSE(raster.height({500014, 4000075}));
  EXPECT_TRUE(raster.area.min.isApprox(Vec2(500015, 4000015)));
  EXPECT_NEAR(raster.cell_m, 30, 1e-9);
}

TEST(Raster, PixelIsPointMeansTheSamePosts) {
  RasterRecipe recipe;
  for (int i = 0; i < 12; ++i) recipe.heights.push_back(static_cast<float>(100 + i));
  recipe.pixel_is_point = true;
  const HeightRaster raster = read(write_raster("point.tif", recipe), Frame::from_crs("EPSG:32616"));
  // GDAL shifts the tie point by half a cell for such files, both in writing and in reading.
  EXPECT_DOUBLE_EQ(*raster.height({500015, 4000075}), 100);
}

TEST(Raster, RotatedRasterIsMappedExactly) {
  RasterRecipe recipe;
  for (int i = 0; i < 12; ++i) recipe.heights.push_back(static_cast<float>(i));
  recipe.geotransform = {500000, 20, 10, 4000000, 10, -20};
  const HeightRaster raster = read(write_raster("rotated.tif", recipe), Frame::from_crs("EPSG:32616"));
  // Post (2, 1): column 2.5, row 1.5 of the cells.
  EXPECT_NEAR(*raster.height({500000 + 2.5 * 20 + 1.5 * 10, 4000000 + 2.5 * 10 - 1.5 * 20}), 6, 1e-6);
}

TEST(Raster, NoDataAndNanAreVoids) {
  RasterRecipe recipe;
  recipe.heights = {-9999, 100, 100, std::nanf(""), 100, 100, 100, 100, 100, 100, 100, -32768};
  recipe.no_data = -9999;
  const HeightRaster raster = read(write_raster("voids.tif", recipe), Frame::from_crs("EPSG:32616"));
  EXPECT_EQ(raster.voids, 3U);
  EXPECT_TRUE(std::isnan(*raster.height({500020, 4000070})));
  EXPECT_DOUBLE_EQ(*raster.height({500060, 4000060}), 100);
}

TEST(Raster, FeetScaleAndOffsetAreHonoured) {
  const HeightRaster feet = read(write_raster("feet.tif", {.unit = "ft"}), Frame::from_crs("EPSG:32616"));
  EXPECT_NEAR(feet.post(0, 0), 30.48, 1e-5);
  const HeightRaster scaled =
      read(write_raster("scaled.tif", {.scale = 0.1, .offset = 50}), Frame::from_crs("EPSG:32616"));
  EXPECT_NEAR(scaled.post(0, 0), 60, 1e-5);
}

TEST(Raster, LocalFrameTakesMetresAsTheyAre) {
  RasterRecipe recipe{.geotransform = std::array<double, 6>{0, 10, 0, 30, 0, -10}, .crs = ""};
  const std::string file = write_raster("local.tif", recipe);
  EXPECT_DOUBLE_EQ(*read(file, Frame::local()).height({5, 5}), 100);
  EXPECT_NE(refusal(file).find("does not say its coordinate system"), std::string::npos);
}

TEST(Raster, GeographicRasterIsNoLocalGround) {
  EXPECT_NE(refusal(test::jacksboro_file(), Frame::local()).find("is not in metres"), std::string::npos);
}

TEST(Raster, AsciiGridWithCrsBesideItIsRead) {
  const std::string base = (test::scratch_folder() / "grid").string();
  write_text(base + ".asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n1 2\n3 4\n");
  EXPECT_DOUBLE_EQ(*read(base + ".asc", Frame::local()).height({5, 5}), 3);
}

TEST(Raster, EveryFaultOfARasterIsNamedAtOnce) {
  RasterRecipe recipe{.columns = 1, .geotransform = std::nullopt, .crs = "", .unit = "furlong"};
  const std::string text = refusal(write_raster("faulty.tif", recipe));
  for (const char* part : {"does not say its coordinate system", "no geotransform", "1 x 3 posts", "furlong"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(Raster, FilesThatAreNoRastersAreRefused) {
  const std::string folder = test::scratch_folder().string();
  EXPECT_EQ(refusal(folder + "/none.tif"), "no such file\n");
  EXPECT_EQ(refusal(folder), "is not a plain file\n");
  write_text(folder + "/empty.tif", "");
  EXPECT_EQ(refusal(folder + "/empty.tif"), "is empty\n");
  write_text(folder + "/words.tif", "not a raster at all");
  EXPECT_NE(refusal(folder + "/words.tif").find("is not a raster"), std::string::npos);
  write_text(folder + "/trick.vrt", "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"></VRTDataset>");
  EXPECT_NE(refusal(folder + "/trick.vrt").find("is not a raster"), std::string::npos);
  EXPECT_EQ(refusal("/dev/zero"), "is not a plain file\n");
}

TEST(Raster, VirtualPathsAreRefused) {
  for (const char* file : {"/vsicurl/http://localhost/a.tif", "/vsicurl?url=http://localhost/a.tif", "/vsimem/a.tif",
                           "/vsizip//vsicurl/http://localhost/a.zip/a.tif", "/vsizip/vsicurl/http://localhost/a.zip",
                           "/vsizip/{/vsicurl/http://localhost/a.zip}/a.tif", "/vsistdin/"})
    EXPECT_NE(refusal(file).find("only plain files and /vsizip/"), std::string::npos) << file;
  EXPECT_EQ(refusal("GTIFF_DIR:1:/vsicurl/http://localhost/a.tif"), "no such file\n");
}

TEST(Raster, TruncatedFilesAreRefused) {
  const std::string whole = test::jacksboro_file();
  const std::string cut = (test::scratch_folder() / "cut.tif").string();
  for (const std::uintmax_t size : {8U, 400U, 1000U, 20'000U, 100'000U, 139'000U}) {
    std::filesystem::copy_file(whole, cut, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(cut, size);
    EXPECT_NE(refusal(cut), "") << size;
  }
}

TEST(Raster, ComplexAndHugeRastersAreRefused) {
  EXPECT_NE(refusal(write_raster("complex.tif", {.type = GDT_CFloat32})).find("complex"), std::string::npos);
  GDALAllRegister();
  const std::string file = (test::scratch_folder() / "huge.tif").string();
  std::string sparse = "SPARSE_OK=TRUE";
  std::array<char*, 2> options{sparse.data(), nullptr};
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  GDALClose(driver->Create(file.c_str(), 15'001, 10'000, 1, GDT_Byte, options.data()));
  EXPECT_NE(refusal(file).find("150010000 cells"), std::string::npos);
}

TEST(Raster, EllipsoidalHeightsAreRefused) {
  RasterRecipe recipe{.geotransform = std::array<double, 6>{-84, 0.001, 0, 36, 0, -0.001}, .crs = "EPSG:4979"};
  EXPECT_NE(refusal(write_raster("ellipsoid.tif", recipe)).find("ellipsoid"), std::string::npos);
}

TEST(Raster, JacksboroLiesWhereItShould) {
  const Frame frame = Frame::utm({36.3, -84.2});
  const HeightRaster raster = read(test::jacksboro_file(), frame);
  EXPECT_EQ(raster.columns, 403);
  EXPECT_EQ(raster.rows, 344);
  EXPECT_EQ(range_of(raster), std::make_pair(236.0F, 1076.0F));
  EXPECT_EQ(raster.voids, 0U);
  EXPECT_EQ(raster.datum, "EGM96 height");
  const auto highest = std::ranges::max_element(raster.posts) - raster.posts.begin();
  const auto row = highest / raster.columns;
  const Vec2 post{static_cast<double>(highest % raster.columns), static_cast<double>(row)};
  const Vec2 cross_mountain = raster.map(*frame.from_geo({36.1983, -84.2308}));
  EXPECT_LT(((cross_mountain - post).cwiseProduct(Vec2(75, 92.5))).norm(), 150);
  // Row 0 is the north edge; the first post lies half a cell inside the corner.
  const double cell = 0.286667 / 344;
  const Vec2 first = raster.map(*frame.from_geo({36.446250 - cell / 2, -84.413750 + cell / 2}));
  EXPECT_NEAR(first.x(), 0, 0.001);
  EXPECT_NEAR(first.y(), 0, 0.001);
}

struct SharedTerrain {
  const char* file;
  int columns, rows;
  double low, high;
  std::size_t voids;
};

void PrintTo(const SharedTerrain& one, std::ostream* out) { *out << one.file; }

class SharedTerrains : public testing::TestWithParam<SharedTerrain> {};

TEST_P(SharedTerrains, OpensWithItsHeights) {
  const SharedTerrain& expected = GetParam();
  const std::string name = std::string("terrain/") + expected.file;
  ALATE_NEEDS_SHARED_DATA(name);
  const bool swiss = name.find("swiss") != std::string::npos;
  // The Swiss rasters in their own frame, the tiles in a frame of the zone of their middle.
  const Frame frame = swiss                                   ? Frame::from_crs("EPSG:21781")
                      : name.find("N46") != std::string::npos ? Frame::utm({46.5, 8.5})
                      : name.find("N49") != std::string::npos ? Frame::utm({49.5, -122.5})
                      : name.find("S33") != std::string::npos ? Frame::utm({-32.5, -70.5})
                                                              : Frame::utm({-35.5, 149.5});
  const HeightRaster raster = read(test::shared_data(name).string(), frame);
  EXPECT_EQ(raster.columns, expected.columns);
  EXPECT_EQ(raster.rows, expected.rows);
  EXPECT_NEAR(range_of(raster).first, expected.low, 0.051);
  EXPECT_NEAR(range_of(raster).second, expected.high, 0.051);
  EXPECT_EQ(raster.voids, expected.voids);
  EXPECT_EQ(raster.datum, swiss ? "not stated (taken as mean sea level)" : "EGM96 mean sea level");
}

INSTANTIATE_TEST_SUITE_P(All, SharedTerrains,
                         testing::Values(SharedTerrain{"swiss/davosdorf.tif", 559, 495, 1535.9, 2843.1, 0},
                                         SharedTerrain{"swiss/sertig_valley.tif", 641, 917, 1491.7, 3002.4, 0},
                                         SharedTerrain{"swiss/duebendorf.tif", 436, 353, 429.0, 542.7, 0},
                                         SharedTerrain{"swiss/duerrboden.tif", 269, 255, 1972.4, 2577.0, 0},
                                         SharedTerrain{"swiss/fluela.tif", 222, 169, 1733.5, 2610.3, 0},
                                         SharedTerrain{"swiss/hinwil.tif", 360, 236, 533.0, 556.5, 0},
                                         SharedTerrain{"srtm3/N46E008.tif", 1201, 1201, 187, 4173, 103743},
                                         SharedTerrain{"srtm3/N49W123.tif", 1201, 1201, -37, 2674, 34926},
                                         SharedTerrain{"srtm3/S33W071.tif", 1201, 1201, 250, 6929, 0},
                                         SharedTerrain{"srtm3/S36E149.tif", 1201, 1201, 7, 1604, 0}));

TEST(SharedTerrain, SrtmCornerPostsLieOnWholeDegrees) {
  ALATE_NEEDS_SHARED_DATA("terrain/srtm3/N46E008.tif");
  const Frame frame = Frame::utm({46.5, 8.5});
  const HeightRaster raster = read(test::shared_data("terrain/srtm3/N46E008.tif").string(), frame);
  EXPECT_LT((raster.map(*frame.from_geo({47, 8})) - Vec2(0, 0)).norm(), 0.001);
  EXPECT_LT((raster.map(*frame.from_geo({46, 9})) - Vec2(1200, 1200)).norm(), 0.001);
}

}  // namespace
}  // namespace alate
