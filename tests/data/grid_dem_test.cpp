// Grids cut from a raster of heights.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "alate/data/site.hpp"
#include "data/scenario_samples.hpp"
#include "support/jacksboro.hpp"
#include "support/raster_files.hpp"

namespace alate {
namespace {

using test::faults_in;
using test::RasterRecipe;
using test::write_raster;

/// A scenario over `dem`, line by line, for faults to name.
std::string over(const std::string& dem, const std::string& cut = "cell_m: 90, level_amsl_m: 650, clearance_m: 60") {
  return "grid: {dem: " + dem + ", " + cut +
         "}\nstart: {lat: 36.378, lon: -84.1263}\ngoal: {lat: 36.2733, lon: -84.3825}\n";
}

std::string on_cells(const std::string& dem, const std::string& cut) {
  return "grid: {dem: " + dem + ", " + cut + "}\nstart: {cell: [0, 0]}\ngoal: {cell: [1, 0]}\n";
}

std::string site_faults(const std::string& text) {
  try {
    load_site(parse_scenario(text, "s.yaml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string all_faults(const std::string& text) {
  std::string all;
  for (const Fault& fault : faults_in(text)) all += to_string(fault) + "\n";
  return all;
}

/// 5 x 4 posts, 30 m apart, in UTM: the first at x 500015, y 4000105.
RasterRecipe slope() {
  RasterRecipe recipe{.columns = 5, .rows = 4, .heights = {}, .geotransform = {{500000, 30, 0, 4000120, 0, -30}}};
  for (int i = 0; i < 20; ++i) recipe.heights.push_back(static_cast<float>(10 * i));
  return recipe;
}

TEST(GridDem, TakesTheHighestPostAround) {
  const std::string dem = write_raster("slope.tif", slope());
  const Site site = load_site(parse_scenario(on_cells(dem, "cell_m: 30, level_amsl_m: 151, clearance_m: 1"), "s.yaml"));
  const HeightGrid& grid = *site.grid;
  // Whole cells of 30 m between x 500015 and 500135, y 4000015 and 4000105.
  EXPECT_EQ(grid.area().min, Vec2(500040, 4000020));
  EXPECT_EQ(grid.area().max, Vec2(500130, 4000080));
  ASSERT_EQ(grid.columns, 3);
  ASSERT_EQ(grid.rows, 2);
  // Upper left: x 500040 to 500070, y 4000050 to 4000080 touches columns 0 to 2 and rows 0 to 2 of the posts.
  EXPECT_EQ(grid.height_m, (std::vector<float>{120, 130, 140, 170, 180, 190}));
  EXPECT_EQ(grid.blocked, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(site.mission.start, Vec3(500055, 4000065, 151));
  EXPECT_EQ(site.band.clearance_m, 1);
  EXPECT_TRUE(site.has_ground());
}

TEST(GridDem, GroundThatReachesTheLevelBlocks) {
  const std::string dem = write_raster("flat.tif", {});
  const auto blocked = [&](const std::string& level) {
    const std::string cut = "cell_m: 20, clearance_m: 20, level_amsl_m: " + level;
    return site_faults(on_cells(dem, cut)).find("is a blocked cell") != std::string::npos;
  };
  EXPECT_FALSE(blocked("120.1"));
  EXPECT_TRUE(blocked("120"));
}

TEST(GridDem, CellsBesideAVoidAreBlockedAndUnknown) {
  RasterRecipe recipe = slope();
  recipe.heights[0] = -999;
  recipe.no_data = -999;
  const std::string dem = write_raster("void.tif", recipe);
  EXPECT_NE(site_faults(on_cells(dem, "cell_m: 30, level_amsl_m: 900"))
                .find("s.yaml:2:15: start.cell: is a blocked cell: its ground is unknown"),
            std::string::npos);
  const std::string text =
      "grid: {dem: " + dem + ", cell_m: 30, level_amsl_m: 900}\n" + "start: {cell: [1, 0]}\ngoal: {cell: [2, 1]}\n";
  const HeightGrid grid = *load_site(parse_scenario(text, "s.yaml")).grid;
  EXPECT_TRUE(grid.blocked_at(0, 0));
  EXPECT_TRUE(std::isnan(grid.height_at(0, 0)));
  EXPECT_EQ(std::ranges::count(grid.blocked, 1), 1);
}

TEST(GridDem, CornersBesideARotatedRasterAreBlocked) {
  RasterRecipe recipe{.columns = 30, .rows = 30, .heights = {}, .geotransform = {{500000, 20, 10, 4000000, 10, -20}}};
  const std::string dem = write_raster("rotated-grid.tif", recipe);
  const std::string text =
      "grid: {dem: " + dem + ", cell_m: 30, level_amsl_m: 900}\n" + "start: {cell: [14, 14]}\ngoal: {cell: [15, 15]}\n";
  const Site site = load_site(parse_scenario(text, "s.yaml"));
  const HeightGrid& grid = *site.grid;
  EXPECT_TRUE(grid.blocked_at(0, 0));
  EXPECT_TRUE(grid.blocked_at(grid.columns - 1, grid.rows - 1));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (grid.blocked_at(column, row)) continue;
      for (const double dx : {-15.0, 15.0}) {
        const Vec2 corner = grid.center(column, row).head<2>() + Vec2(dx, 15);
        EXPECT_TRUE(site.ground_height(corner));
      }
    }
  }
}

TEST(GridDem, NoGroundIsHigherThanItsCell) {
  const Site site = load_site(parse_scenario(over(test::jacksboro_file()), "s.yaml"));
  const HeightGrid& grid = *site.grid;
  EXPECT_FALSE(site.frame.is_local());
  EXPECT_TRUE(site.frame.to_geo(site.mission.start.head<2>()));
  std::mt19937 random(5);
  const Vec2 size = grid.area().max - grid.area().min;
  std::uniform_real_distribution<double> part(0, 1);
  std::size_t known = 0;
  double excess = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Vec2 at = grid.area().min + Vec2(part(random) * size.x(), part(random) * size.y());
    const auto [column, row] = *grid.cell_at(at);
    const double height = grid.height_at(column, row);
    EXPECT_EQ(grid.blocked_at(column, row), !(height + 60 < 650));
    if (std::isnan(height)) continue;
    ++known;
    const double ground = *site.ground_height(at);
    ASSERT_GE(height, ground);
    excess += height - ground;
  }
  EXPECT_GT(known, 94'000U);
  EXPECT_LT(excess / static_cast<double>(known), 40);  // of a terrain that rises by some 20 m a post
}

TEST(GridDem, CellsStayWhereStartAndGoalMove) {
  const auto area = [](const std::string& goal) {
    const std::string text = test::with(over(test::jacksboro_file()), "lat: 36.2733, lon: -84.3825", goal);
    return load_site(parse_scenario(text, "s.yaml")).grid->area().min;
  };
  EXPECT_EQ(area("lat: 36.2733, lon: -84.3825"), area("cell: [300, 40]"));
}

TEST(GridDem, TooFineOrTooCoarse) {
  const std::string text = over(test::jacksboro_file());
  const std::string fine = site_faults(test::with(text, "cell_m: 90", "cell_m: 1"));
  EXPECT_NE(fine.find("grid.cell_m: cuts the terrain into"), std::string::npos) << fine;
  EXPECT_NE(fine.find("a grid has 10000 columns, 10000 rows and 16000000 cells at most (got 1, allowed >= "),
            std::string::npos)
      << fine;
  const std::string least = fine.substr(fine.find(">= ") + 3, 4);
  EXPECT_EQ(site_faults(test::with(text, "cell_m: 90", "cell_m: " + least)), "") << least;
  const std::string dem = write_raster("small.tif", {});
  EXPECT_NE(site_faults(on_cells(dem, "cell_m: 500, level_amsl_m: 900"))
                .find("grid.cell_m: no whole cell lies within the terrain (got 500, allowed <= 30 m)"),
            std::string::npos);
}

TEST(GridDem, FaultsOfTheScenario) {
  const std::string text = over("d.tif");
  EXPECT_EQ(all_faults(test::with(text, "level_amsl_m: 650, ", "")),
            "s.yaml:1:1: grid: needs exactly one of these sets of keys (got dem, allowed map | random | dem, "
            "level_amsl_m)\n");
  EXPECT_EQ(all_faults(test::with(text, "cell_m: 90, ", "")),
            "s.yaml:1:1: grid.cell_m: is missing: a dem is cut into cells of it (allowed >= 0.01 m)\n");
  EXPECT_EQ(all_faults(test::with(text, "cell_m: 90", "cell_m: 0")),
            "s.yaml:1:28: grid.cell_m: out of range (got 0, allowed 0.01 to 10000 m)\n");
  EXPECT_EQ(all_faults(test::with(text, "cell_m: 90", "cell_m: 90, heights: peaks")),
            "s.yaml:1:41: grid.heights: a dem has its own heights\n");
  EXPECT_EQ(all_faults(test::with(test::kGridScenario, "cell_m: 10", "cell_m: 10, clearance_m: 5")),
            "s.yaml:1:100: grid.clearance_m: belongs to a grid cut from a dem\n");
}

TEST(GridDem, FaultsOfStartAndGoal) {
  const std::string text = over("d.tif");
  EXPECT_EQ(all_faults(test::with(text, "lon: -84.1263", "lon: -84.1263, amsl_m: 700")),
            "s.yaml:2:45: start.amsl_m: the route flies at grid.level_amsl_m; leave this height out\n");
  EXPECT_EQ(all_faults(test::with(text, "{lat: 36.378, lon: -84.1263}", "{position_m: [1, 2, 3]}")),
            "s.yaml:2:1: start: must be a cell of the grid (allowed {cell: [column, row]} or {lat, lon})\n");
  EXPECT_EQ(all_faults("start: {lat: 1, lon: 2}\ngoal: {lat: 1, lon: 2, amsl_m: 3}\n"),
            "s.yaml:1:1: start: needs a height; only beside grid.dem lat and lon are enough (allowed lat, lon, amsl_m "
            "| lat, lon, agl_m)\n");
  EXPECT_EQ(all_faults("frame: {local: true}\n" + text),
            "s.yaml:3:14: start.lat: a local frame has no place on Earth; write metres in the frame\n"
            "s.yaml:4:13: goal.lat: a local frame has no place on Earth; write metres in the frame\n");
}

TEST(GridDem, EndsThatAreNoFreeCell) {
  const std::string text = over(test::jacksboro_file());
  const std::string low = site_faults(test::with(text, "level_amsl_m: 650", "level_amsl_m: 400"));
  EXPECT_NE(low.find("s.yaml:2:1: start: is a blocked cell: its ground and clearance_m reach "), std::string::npos)
      << low;
  EXPECT_NE(low.find(" m, the flight level is 400.0 m (got ["), std::string::npos) << low;
  const std::string far = site_faults(test::with(text, "lat: 36.2733", "lat: 37.2733"));
  EXPECT_NE(far.find("s.yaml:3:1: goal: lies outside the grid (got lat 37.273300, lon -84.382500, allowed lat "),
            std::string::npos)
      << far;
}

TEST(GridDem, RasterThatCannotBeUsed) {
  EXPECT_NE(site_faults(over("/nowhere/x.tif")).find("s.yaml:1:13: grid.dem: no such file"), std::string::npos);
  RasterRecipe nowhere;
  nowhere.crs.clear();
  const std::string dem = write_raster("nowhere.tif", nowhere);
  EXPECT_NE(site_faults(over(dem)).find("s.yaml:1:13: grid.dem: does not say its coordinate system"), std::string::npos)
      << site_faults(over(dem));
  // In a local frame its metres are enough.
  const std::string local = "frame: {local: true}\n" + on_cells(dem, "cell_m: 20, level_amsl_m: 900");
  EXPECT_EQ(site_faults(local), "");
}

TEST(GridDem, IsWrittenBackAsItWasRead) {
  const Scenario scenario = parse_scenario(over("d.tif"), "s.yaml");
  EXPECT_EQ(parse_scenario(to_yaml(scenario), "s.yaml"), scenario);
}

}  // namespace
}  // namespace alate
