// The report of a route over a grid.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "data/grid_law.hpp"
#include "out/report/grid_layer.hpp"
#include "out/report/report.hpp"
#include "support.hpp"
#include "xml_balance.hpp"

namespace alate {
namespace {

using test::Flight;

/// Along the left and upper side of a grid of 30 x 30 cells, cleared of what is blocked there.
void fly_over_grid(Flight& flight, double cell_m = 1) {
  Site& site = flight.site;
  site.scenario.file = "yin2021/30x30.yaml";
  site.ground = std::monostate{};
  site.frame = Frame::local();
  site.threats.clear();
  site.band = {};
  site.grid = draw_grid({.size = {30, 30}, .obstacles = 0.2, .seed = 1}, {{0, 29}}, {{29, 0}});
  site.grid->height_m = peak_heights(30, 30);
  site.grid->cell_m = cell_m;
  for (int i = 0; i < 30; ++i)
    site.grid->blocked[site.grid->index(0, i)] = site.grid->blocked[site.grid->index(i, 0)] = 0;
  site.mission = {.start = site.grid->center(0, 29), .goal = site.grid->center(29, 0)};
  flight.result.plan.route.states = {{.position = site.mission.start, .leg = LegKind::start},
                                     {.position = site.grid->center(0, 0)},
                                     {.position = site.mission.goal}};
  flight.result.plan.outcome = Outcome::feasible;
  flight.result.metrics = measure(site, flight.result.plan.route);
  flight.result.verdict = check(site, flight.result.plan.route);
}

TEST(GridReport, ShowsCellsHeightsAndMeasures) {
  Flight flight;
  fly_over_grid(flight);
  ASSERT_TRUE(flight.result.verdict.ok());
  const std::string html = report_html(flight.result);
  EXPECT_EQ(test::xml_fault(html), "");
  for (const char* part : {"relief cells", "Blocked cell", "Ground from, m:", "composite index", "deviation of height",
                           "no blocked cell, no corner of one cut", "grid of 30 x 30 cells"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("Height along the way"), std::string::npos);
}

TEST(GridReport, CutFromTerrainHasAProfileAndAPlainLine) {
  Flight flight;
  flight.site = load_site(load_scenario(ALATE_SOURCE_DIR "/examples/yin2021/jacksboro.yaml"));
  Route& route = flight.result.plan.route;
  route.states = {{.position = flight.site.mission.start, .leg = LegKind::start}};
  for (int i = 1; i <= 5; ++i)
    route.states.push_back({.position = flight.site.mission.start + Vec3(-flight.site.grid->cell_m * i, 0, 0)});
  flight.result.metrics = measure(flight.site, route);
  flight.result.verdict = check(flight.site, route);
  const std::string crowded = report_html(flight.result);
  EXPECT_EQ(test::xml_fault(crowded), "");
  for (const char* part : {"Height along the way", "no corner of one cut; at least", "cells, 90 m wide"})
    EXPECT_NE(crowded.find(part), std::string::npos) << part;
  EXPECT_EQ(crowded.find("class=\"waypoint\""), std::string::npos);
  for (std::size_t i = 0; i < route.states.size(); ++i)
    route.states[i].position =
        flight.site.mission.start + Vec3(-20 * flight.site.grid->cell_m * static_cast<double>(i), 0, 0);
  EXPECT_NE(report_html(flight.result).find("class=\"waypoint\""), std::string::npos);
}

TEST(GridReport, PictureHasOnePixelACell) {
  HeightGrid grid{.columns = 2, .rows = 2, .blocked = {0, 1, 0, 0}, .height_m = {0, 0, 3, 8}};
  const Hillshade picture = grid_picture(grid);
  ASSERT_EQ(picture.image.pixels.size(), 4U);
  EXPECT_EQ(picture.image.pixels[1], picture.image.palette.size() - 1);
  EXPECT_EQ(picture.image.pixels[0], 0);
  EXPECT_LT(picture.image.pixels[2], picture.image.pixels[3]);
  grid.height_m.clear();
  const Hillshade flat = grid_picture(grid);
  EXPECT_TRUE(flat.bands.empty());
  EXPECT_EQ(flat.image.pixels, (std::vector<std::uint8_t>{0, 1, 0, 0}));
}

TEST(GridReport, LargeGridsShareAPixelAndLoseNoWall) {
  HeightGrid grid{.columns = 4000, .rows = 3999, .blocked = std::vector<std::uint8_t>(std::size_t{4000} * 3999)};
  grid.blocked[grid.index(3999, 3998)] = 1;
  const Hillshade picture = grid_picture(grid);
  EXPECT_LE(picture.image.columns, 1500);
  EXPECT_EQ(picture.image.pixels.size(), static_cast<std::size_t>(picture.image.columns * picture.image.rows));
  EXPECT_EQ(picture.image.pixels.back(), 1);
}

}  // namespace
}  // namespace alate
