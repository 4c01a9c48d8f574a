// The pieces that the report's pictures are made of.
#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "out/report/axis.hpp"
#include "out/report/hillshade.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/number_words.hpp"
#include "out/report/profile.hpp"
#include "support.hpp"

namespace alate {
namespace {

using test::Flight;

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_step(1), 1);
  EXPECT_DOUBLE_EQ(round_step(1.1), 2);
  EXPECT_DOUBLE_EQ(round_step(21), 50);
  EXPECT_DOUBLE_EQ(round_step(0.6), 1);
  EXPECT_DOUBLE_EQ(round_step(0.0123), 0.02);
}

RC_GTEST_PROP(Ticks, LieInOrderWithinTheRange, ()) {
  const double from = *rc::gen::inRange(-100000, 100000) / 7.0;
  const double to = from + *rc::gen::inRange(1, 100000) / 13.0;
  const int about = *rc::gen::inRange(2, 12);
  const auto values = ticks(from, to, about);
  const double slack = 1e-6 * (to - from);
  RC_ASSERT(values.size() <= static_cast<std::size_t>(about) + 1);
  RC_ASSERT(std::ranges::is_sorted(values));
  for (const double value : values) RC_ASSERT(value >= from - slack && value <= to + slack);
}

TEST(TickLabel, ShowsTheDigitsOfItsStep) {
  EXPECT_EQ(tick_label(ticks(-0.5, 1, 3).at(1), 0.5), "0.0");
  EXPECT_EQ(tick_label(1200, 200), "1200");
  EXPECT_EQ(tick_label(0.25, 0.05), "0.25");
}

TEST(Quantity, ReadsWell) {
  EXPECT_EQ(quantity(29156.7, "m"), "29\u202F157\u00A0m");
  EXPECT_EQ(quantity(1.3401, "deg"), "1.34°");
  EXPECT_EQ(quantity(-12.5, "m"), "-12.5\u00A0m");
  EXPECT_EQ(quantity(-0.0001, "m"), "0\u00A0m");
  EXPECT_EQ(quantity(300, ""), "300");
  EXPECT_EQ(quantity(INFINITY, "m"), "–");
  EXPECT_EQ(whole(1234567), "1\u202F234\u202F567");
}

TEST(Png, ReadsBackToTheSamePixels) {
  const IndexedImage image{
      .columns = 3, .rows = 2, .pixels = {0, 1, 2, 2, 1, 0}, .palette = {{{1, 2, 3}, {40, 50, 60}, {255, 0, 128}}}};
  const std::string bytes = to_png(image);
  png_image reader{.version = PNG_IMAGE_VERSION};
  ASSERT_NE(png_image_begin_read_from_memory(&reader, bytes.data(), bytes.size()), 0);
  reader.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(reader));
  ASSERT_NE(png_image_finish_read(&reader, nullptr, rgb.data(), 0, nullptr), 0);
  ASSERT_EQ(rgb.size(), 18U);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(rgb[3 * i + c], image.palette[image.pixels[i]][c]);
  }
}

int lightness(const Hillshade& ground, double column, double row) {
  const IndexedImage& image = ground.image;
  const auto x = static_cast<std::size_t>(column * image.columns);
  const auto y = static_cast<std::size_t>(row * image.rows);
  const Rgb& color = image.palette[image.pixels[y * static_cast<std::size_t>(image.columns) + x]];
  return color[0] + color[1] + color[2];
}

TEST(Hillshade, IsLitFromTheNorthWest) {
  const Site site = test::hill_site();
  const Hillshade ground = hillshade(site, {.min = {3000, 2000}, .max = {7000, 6000}}, 200);
  EXPECT_GT(lightness(ground, 0.35, 0.35), lightness(ground, 0.65, 0.65) + 60);
  EXPECT_FALSE(ground.has_unknown);
  ASSERT_FALSE(ground.bands.empty());
  EXPECT_LE(ground.bands.front().from_m, site.ground_height({3000, 2000}).value());
}

TEST(Hillshade, MarksWhatLiesOutsideTheGround) {
  const Hillshade ground = hillshade(test::hill_site(), {.min = {-4000, 2000}, .max = {4000, 6000}}, 100);
  EXPECT_TRUE(ground.has_unknown);
  const auto corner = ground.image.pixels.front();
  EXPECT_GE(corner, 248);
}

TEST(MapFrame, HoldsTheFlightInPleasantProportions) {
  Flight flight;
  flight.find_route();
  flight.site.threats.push_back({.name = "far", .center = {90000, 0, 0}, .radius_m = 100});
  const MapFrame map = map_frame(flight.site, flight.result.plan.route, 1000);
  for (const RouteState& state : flight.result.plan.route.states) {
    EXPECT_TRUE(map.area.contains(state.position.head<2>()));
  }
  EXPECT_LE(map.height(), 1001);
  EXPECT_GE(map.height(), 499);
  EXPECT_LT(map.area.max.x(), 20000);
  EXPECT_LT(map(flight.site.mission.goal).y(), map(flight.site.mission.start).y());  // north is up
}

TEST(MapFrame, TakesAFlightThatGoesNowhere) {
  Flight flight;
  flight.site.mission.goal = flight.site.mission.start;
  flight.site.mission.tolerance_m = 0;
  flight.site.threats.clear();
  const MapFrame map = map_frame(flight.site, {}, 1000);
  EXPECT_TRUE(std::isfinite(map.height()));
  EXPECT_GT(map.height(), 0);
}

TEST(Profile, FollowsTheRouteOverTheGround) {
  Flight flight;
  flight.find_route();
  const auto samples = sample_profile(flight.site, flight.result.plan.route, 300);
  EXPECT_GT(samples.size(), 290U);
  EXPECT_TRUE(samples.back().position == (Vec3{9000, 7000, 200}));
  EXPECT_NEAR(samples.back().along_m, 4005 + 3499 + 4123, 1);
  for (const ProfileSample& sample : samples)
    EXPECT_NEAR(sample.ground_m.value(), *flight.site.ground_height(sample.position.head<2>()), 1e-9);
}

TEST(Profile, FindsTheStretchInsideAThreat) {
  Flight flight;
  flight.find_route();
  flight.site.threats = {{.name = "low", .center = {3000, 1100, 150}, .radius_m = 500},
                         {.name = "deep",
                          .shape = Threat::Shape::cylinder,
                          .center = {3000, 1100, 0},
                          .radius_m = 500,
                          .floor_m = 0,
                          .top_m = 100}};
  const auto samples = sample_profile(flight.site, flight.result.plan.route, 2000);
  const auto spans = threat_spans(flight.site, samples);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0].name, "low");
  EXPECT_NEAR(spans[0].to_m - spans[0].from_m, 1000, 15);
}

TEST(Profile, MarksTheLowestPlaceByTheCheckOrByItself) {
  Flight flight;
  flight.find_route();
  const auto samples = sample_profile(flight.site, flight.result.plan.route, 300);
  const auto judged = lowest_clearance(flight.result, samples);
  ASSERT_TRUE(judged.has_value());
  EXPECT_NEAR(judged->position.x(), 3000, 1e-9);
  EXPECT_NEAR(judged->along_m, 2002, 30);
  flight.result.verdict.margins.clear();
  const auto own = lowest_clearance(flight.result, samples);
  ASSERT_TRUE(own.has_value());
  for (const ProfileSample& s : samples)
    EXPECT_LE(own->position.z() - *own->ground_m, s.position.z() - *s.ground_m + 1e-9);
}

}  // namespace
}  // namespace alate
