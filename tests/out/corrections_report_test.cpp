// The report of a flight with navigation errors: points on the map, errors along the way, the front.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "out/report/errors_view.hpp"
#include "out/report/report.hpp"
#include "support.hpp"
#include "xml_balance.hpp"

namespace alate {
namespace {

using test::Flight;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Two corrections on a line of 30 km, the first leg partly an arc; 20 more points beside it.
void fly_corrected(Flight& flight) {
  Site& site = flight.site;
  site.ground = std::monostate{};
  site.frame = Frame::local();
  site.threats.clear();
  site.mission = {.start = {0, 0, 0}, .goal = {30'000, 0, 0}};
  Navigation navigation{.drift_vertical = 0.001,
                        .drift_horizontal = 0.001,
                        .at_vertical = {.vertical = 25, .horizontal = 15},
                        .at_horizontal = {.vertical = 20, .horizontal = 25},
                        .theta = 30,
                        .residual = 5};
  navigation.points = {{.id = 41, .position = {10'000, 0, 0}, .kind = PointKind::vertical},
                       {.id = 42, .position = {20'000, 0, 0}, .kind = PointKind::horizontal, .success = 0.8}};
  for (int i = 0; i < 20; ++i)
    navigation.points.push_back({.id = i, .position = {1000.0 * i, 500, 0}, .kind = PointKind::horizontal});
  site.navigation = navigation;
  Route& route = flight.result.plan.route;
  route.states = {{.position = site.mission.start, .leg = LegKind::start},
                  {.position = {2000, 0, 0}, .leg = LegKind::arc, .arc = Arc{{1000, 0}, 1000, kPi}},
                  {.position = {10'000, 0, 0}, .point_id = 41},
                  {.position = {20'000, 0, 0}, .point_id = 42},
                  {.position = site.mission.goal}};
  flight.result.plan.outcome = Outcome::feasible;
  flight.result.plan.front = {{.length_m = 33'000, .corrections = 1, .probability = 1, .points = {3}},
                              {.length_m = 31'141.6, .corrections = 2, .probability = 0.8, .points = {41, 42}}};
  flight.result.metrics = measure(site, route);
  flight.result.verdict = check(site, route);
}

TEST(CorrectionsReport, ShowsPointsErrorsAndFront) {
  Flight flight;
  fly_corrected(flight);
  ASSERT_TRUE(flight.result.verdict.ok());
  const std::string html = report_html(flight.result);
  EXPECT_EQ(test::xml_fault(html), "");
  for (const char* part : {"2 corrections", "chance of success", "Navigation errors along the way",
                           "The best trade-offs", "42: horizontal, works with a chance of 80.0 %", "41: vertical",
                           "Corrects the vertical error", "The correction may fail", ">41 42 <b>(this route)</b>",
                           "at most 25 units at vertical, 20 at horizontal points", "below 30 units"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(count_of(html, "point vertical used"), 1U);
  EXPECT_EQ(count_of(html, "point horizontal unsure used"), 1U);
  EXPECT_EQ(count_of(html, "class=\"chosen\""), 1U);
}

TEST(CorrectionsReport, ErrorsFallAtTheirCorrections) {
  Flight flight;
  fly_corrected(flight);
  const std::string figure = errors_figure(flight.result);
  EXPECT_EQ(count_of(figure, "error-limit vertical"), 3U);
  EXPECT_EQ(count_of(figure, "error-limit horizontal"), 3U);
  // Vertical: up from the axis, down to it at the first point (11.1 of 31.1 km), up to the end.
  EXPECT_NE(figure.find("points=\"78.0,336.0 400.7,236.3 400.7,336.0 690.4,246.5 690.4,246.5 980.0,157.0"),
            std::string::npos)
      << figure;
}

TEST(CorrectionsReport, OtherFlightsShowNoneOfIt) {
  Flight flight;
  flight.find_route();
  const std::string html = report_html(flight.result);
  for (const char* part : {"chance of success", "Navigation errors", "trade-offs", "Corrects the"})
    EXPECT_EQ(html.find(part), std::string::npos) << part;
}

TEST(CorrectionsReport, OfManyPointsAFewThousandAreDrawn) {
  Flight flight;
  fly_corrected(flight);
  for (int i = 0; i < 100'000; ++i)
    flight.site.navigation->points.push_back({.id = 1000 + i, .position = {0.3 * i, 100.0 * (i % 7), 0}});
  const std::string html = report_html(flight.result);
  EXPECT_LT(html.size(), 1'000'000U);
  EXPECT_NE(html.find(" points is drawn, and those of the route."), std::string::npos);
  EXPECT_EQ(count_of(html, "point horizontal unsure used"), 1U);
}

}  // namespace
}  // namespace alate
