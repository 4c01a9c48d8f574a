#include "out/report/report.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support.hpp"
#include "xml_balance.hpp"

namespace alate {
namespace {

using test::Flight;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Four by four posts a kilometre apart; one is void.
HeightRaster raster_with_void() {
  HeightRaster raster{.columns = 11,
                      .rows = 9,
                      .posts = std::vector<float>(99, 50.0F),
                      .map = PostMap::affine({0, 0.001, 0, 8, 0, -0.001}),
                      .area = {.min = {0, 0}, .max = {10000, 8000}},
                      .cell_m = 1000,
                      .name = "small.tif",
                      .crs = "EPSG:32632",
                      .datum = "EGM96 height",
                      .voids = 1};
  raster.posts[40] = std::numeric_limits<float>::quiet_NaN();
  return raster;
}

void expect_sound(const std::string& html) {
  EXPECT_EQ(test::xml_fault(html), "");
  EXPECT_LT(html.size(), 1'500'000U);
  for (const char* outside : {"http:", "https:", "<script", "url(", "src=", "@import", "javascript:"})
    EXPECT_FALSE(contains(html, outside)) << outside;
}

TEST(Report, ShowsTheRouteAndWhyItIsSafe) {
  Flight flight;
  flight.find_route();
  flight.result.files = {"result.json", "route.plan"};
  flight.result.warnings = {"mind the wind"};
  const std::string html = report_html(flight.result);
  expect_sound(html);
  for (const char* part :
       {"<h1>hill</h1>", "keeps all 1 rules", "verdict pass", "at most 10.5 % above the best possible", "radar",
        "Start", "Goal", "data:image/png;base64,", "lowest: ", "terrain_clearance", "no zones were given",
        "at least 60", "score&#160;=&#160;J+h", "Seed", "href=\"route.plan\"", "mind the wind", "not clearance to fly",
        "Trees, masts and wires", "clearance_m"})
    EXPECT_TRUE(contains(html, part)) << part;
}

TEST(Report, SaysWhyThereIsNoRoute) {
  Flight flight;
  flight.result.plan.outcome = Outcome::infeasible_proven;
  flight.result.plan.why = "a wall <everywhere>";
  const std::string html = report_html(flight.result);
  expect_sound(html);
  EXPECT_TRUE(contains(html, "There is no route: a wall &lt;everywhere&gt;."));
  EXPECT_TRUE(contains(html, "verdict fail"));
  EXPECT_TRUE(contains(html, "radar"));
  EXPECT_FALSE(contains(html, "What was checked"));
}

TEST(Report, ShowsABrokenRuleAsBroken) {
  Flight flight;
  flight.find_route();
  flight.result.verdict.status = Status::fail;
  flight.result.verdict.margins[0].margin = -5;
  flight.result.verdict.violations = {{.rule = "terrain_clearance", .leg = 1, .where = {3000, 1100, 115}},
                                      {.rule = "fence", .leg = 2, .where = {3000, 1100, 115}, .value = 3, .unit = "m"}};
  const std::string html = report_html(flight.result);
  expect_sound(html);
  EXPECT_TRUE(contains(html, "must not be flown"));
  EXPECT_TRUE(contains(html, "over the limit"));
  EXPECT_TRUE(contains(html, "<code>fence</code>"));
}

TEST(Report, DoesNoHarmWithNamesFromFiles) {
  Flight flight;
  flight.find_route();
  const std::string evil = "\"><script>alert(1)</script>";
  flight.site.threats[0].name = evil;
  flight.site.scenario.file = evil;
  flight.site.scenario.threats.push_back({.name = evil, .center_m = std::array{0.0, 0.0, 0.0}, .radius_m = 1});
  flight.site.warnings = {evil};
  flight.result.verdict.not_checked = {{.rule = evil, .why = evil}};
  const std::string html = report_html(flight.result);
  expect_sound(html);
  EXPECT_TRUE(contains(html, "&lt;script&gt;alert(1)&lt;/script&gt;"));
}

TEST(Report, HatchesUnknownGround) {
  Flight flight;
  flight.find_route();
  flight.site.ground = raster_with_void();
  flight.result.verdict.margins.clear();
  const std::string html = report_html(flight.result);
  expect_sound(html);
  EXPECT_TRUE(contains(html, "Ground not known"));
  EXPECT_TRUE(contains(html, "small.tif, one height every 1e+03 m") || contains(html, "one height every 1000"));
}

TEST(Report, IsAPlainMapWithoutGround) {
  Flight flight;
  flight.find_route();
  flight.site.ground = std::monostate{};
  flight.site.frame = Frame::local();
  flight.result.metrics.min_clearance_m.reset();
  flight.result.verdict.margins.clear();
  const std::string html = report_html(flight.result);
  expect_sound(html);
  EXPECT_FALSE(contains(html, "data:image"));
  EXPECT_TRUE(contains(html, "No terrain was given"));
}

TEST(Report, TakesARouteOfOneState) {
  Flight flight;
  flight.find_route();
  flight.result.plan.route.states.resize(1);
  flight.site.mission.goal = flight.site.mission.start;
  expect_sound(report_html(flight.result));
}

}  // namespace
}  // namespace alate
