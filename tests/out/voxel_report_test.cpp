// The report of a route among voxels.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "out/report/grid_layer.hpp"
#include "out/report/report.hpp"
#include "support.hpp"
#include "xml_balance.hpp"

namespace alate {
namespace {

TEST(VoxelReport, ShowsTheMapFromAboveAndTheHeightsFlown) {
  test::Flight flight;
  flight.site = load_site(load_scenario(ALATE_SOURCE_DIR "/examples/voxels/scenario.yaml"));
  Route& route = flight.result.plan.route;
  route.states = {{.position = flight.site.mission.start, .leg = LegKind::start},
                  {.position = flight.site.mission.start + Vec3(0, 0, 100)},
                  {.position = flight.site.mission.goal + Vec3(0, 0, 100)},
                  {.position = flight.site.mission.goal}};
  flight.result.plan.outcome = Outcome::feasible;
  flight.result.metrics = measure(flight.site, route);
  flight.result.verdict = check(flight.site, route);
  const std::string html = report_html(flight.result);
  EXPECT_EQ(test::xml_fault(html), "");
  for (const char* part : {"relief cells", "Top of the highest blocked cell", "Height along the way", "class=\"voxel\"",
                           "Blocked cells above and below", "map of 30 x 20 x 12 voxels",
                           "no blocked cell, no edge or corner of one cut", "climb, all told"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("composite index"), std::string::npos);
}

TEST(VoxelReport, ColumnsAreAsHighAsTheirHighestBlockedCell) {
  VoxelGrid voxels({3, 2, 9}, 2);
  voxels.block({0, 0, 1});
  voxels.block({0, 0, 4});
  voxels.block({2, 1, 7});
  const HeightGrid tops = seen_from_above(voxels);
  EXPECT_EQ(tops.height_at(0, 1), 10);  // row 1 is the south
  EXPECT_EQ(tops.height_at(2, 0), 16);
  EXPECT_TRUE(std::isnan(tops.height_at(1, 0)));
  const Hillshade picture = voxel_picture(tops);
  const auto open = static_cast<std::uint8_t>(picture.image.palette.size() - 1);
  ASSERT_EQ(picture.image.pixels.size(), 6U);
  EXPECT_EQ(picture.image.pixels[0], open);
  EXPECT_EQ(picture.image.pixels[3], 0);
  EXPECT_GT(picture.image.pixels[2], 0);
  EXPECT_LT(picture.image.pixels[2], open);
}

}  // namespace
}  // namespace alate
