#include <gtest/gtest.h>

#include <fstream>

#include "alate/data/site.hpp"
#include "data/scenario_samples.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

using test::kNavigationScenario;
using test::with;

Site site_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return load_site(parse_scenario(text, "s.yaml", overrides));
}

/// All faults, one a line.
std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    site_of(text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Navigation, ListsNeedNeitherFrameNorEnds) {
  const Site site = site_of(kNavigationScenario);
  EXPECT_TRUE(site.frame.is_local());
  EXPECT_EQ(site.mission.start, Vec3(0, 0, 100));
  EXPECT_EQ(site.mission.goal, Vec3(14000, 0, 100));
  EXPECT_EQ(site.scenario.objective.climb, 0);
  ASSERT_TRUE(site.navigation);
  const Navigation& navigation = *site.navigation;
  ASSERT_EQ(navigation.points.size(), 2U);
  EXPECT_EQ(navigation.points[0].success, 0.75);
  EXPECT_EQ(navigation.points[1].id, 2);
  EXPECT_EQ(navigation.points[1].kind, PointKind::horizontal);
  EXPECT_EQ(navigation.points[1].success, 1);
  EXPECT_EQ(navigation.drift_horizontal, 0.002);
  EXPECT_EQ(navigation.at_vertical.horizontal, 15);
  EXPECT_EQ(navigation.at_horizontal.vertical, 20);
  EXPECT_EQ(navigation.start_id, 7);
  EXPECT_EQ(navigation.goal_id, 9);
  EXPECT_EQ(navigation.turn_model, TurnModel::arc_tangent);
  EXPECT_EQ(navigation.turn_radius_m, 200);
}

TEST(Navigation, ClimbKeepsTheWeightThatIsGiven) {
  EXPECT_EQ(site_of(kNavigationScenario + "objective: {climb: 3}\n").scenario.objective.climb, 3);
}

TEST(Navigation, EndsMayStandInTheScenarioToo) {
  const std::string start = "start: {position_m: [0.5, 0, 100]}\n";
  EXPECT_EQ(site_of(kNavigationScenario + start).mission.start, Vec3(0, 0, 100));
  EXPECT_EQ(
      refusal(kNavigationScenario + "start: {position_m: [0, 2, 100]}\n"),
      "s.yaml:15:1: start: does not lie at point 7, which is the same end of the flight (got 2.00, allowed <= 1 m)");
}

TEST(Navigation, WithoutEndsTheScenarioMustHaveThem) {
  std::string text = with(kNavigationScenario, "  - {id: 7, position_m: [0, 0, 100], kind: start}\n", "");
  EXPECT_EQ(refusal(text),
            "s.yaml:3:3: navigation.points: the points have an end but no start (allowed one start and one end, or "
            "neither)");
  text = with(text, "  - {id: 9, position_m: [14000, 0, 100], kind: end}\n", "");
  EXPECT_EQ(refusal(text),
            "s.yaml: start: is missing: neither the scenario nor its points have it\n"
            "s.yaml: goal: is missing: neither the scenario nor its points have it");
  const Site site = site_of(text + "start: {position_m: [1, 2, 3]}\ngoal: {position_m: [4, 5, 6]}\n");
  EXPECT_EQ(site.mission.goal, Vec3(4, 5, 6));
  EXPECT_EQ(site.navigation->start_id, Navigation::kNoId);
}

TEST(Navigation, PointsMustBeNamed) {
  EXPECT_EQ(refusal("navigation: {alpha: [1, 2], beta: [3, 4], theta: 5}\n"),
            "s.yaml:1:1: navigation.points: is missing: name it here, or by --override navigation.points=FILE "
            "(allowed a CSV file or a list of points)");
  EXPECT_EQ(refusal("navigation: {alpha: [1, 2], beta: [3, 4], theta: 5}\n", {"navigation.points=no.csv"}),
            "--override: navigation.points: no such file (got no.csv)");
}

TEST(Navigation, FaultsOfListsCarryTheirPlace) {
  const std::string text = with(kNavigationScenario, "id: 8", "id: 7");
  EXPECT_EQ(refusal(text), "s.yaml:4:10: navigation.points.1.id: another point has this id (got 7)");
  EXPECT_EQ(refusal(with(kNavigationScenario, "id: 8", "id: 0.5")),
            "s.yaml:4:10: navigation.points.1.id: must be a whole number (got 0.5)");
  EXPECT_EQ(refusal(with(kNavigationScenario, "turn_radius_m: 200", "success: 1")),
            "s.yaml:1:1: navigation.turn_radius_m: is needed by turn_model (allowed > 0 m)\n"
            "s.yaml:13:3: navigation.success: given twice, first in line 11");
  EXPECT_EQ(refusal(with(kNavigationScenario, "theta: 30", "theta: 0")),
            "s.yaml:10:10: navigation.theta: out of range (got 0, allowed > 0 units)");
}

TEST(Navigation, FilesAreRelativeToTheScenario) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "alate_on_earth.csv")
      << "id,lat,lon,amsl_m,kind,may_fail\n0,47,8.9,500,start,0\n1,47,9,600,vertical,1\n2,47,9.1,500,end,0\n";
  const std::string text = "navigation: {points: alate_on_earth.csv, alpha: [25, 15], beta: [20, 25], theta: 30}\n";
  const Site site = load_site(parse_scenario(text, folder + "s.yaml"));
  EXPECT_EQ(site.frame.name(), "EPSG:32632");
  ASSERT_EQ(site.navigation->points.size(), 1U);
  EXPECT_NEAR((site.navigation->points[0].position - site.mission.start).head<2>().norm(), 7600, 20);
  EXPECT_EQ(site.navigation->points[0].position.z(), 600);
  EXPECT_THROW(load_site(parse_scenario(text + "frame: {local: true}\n", folder + "s.yaml")), InputError);
}

TEST(Navigation, MetresAndDegreesNeedAFrame) {
  const std::string text = with(kNavigationScenario, "position_m: [5000, 100, 200]", "lat: 47, lon: 9, amsl_m: 0");
  EXPECT_NE(refusal(text).find("some places are in metres and some in lat and lon"), std::string::npos);
  EXPECT_EQ(site_of(text + "frame: {origin: {lat: 47, lon: 9}}\n").navigation->points[0].position.norm(), 0);
}

TEST(Navigation, ContestSetNeedsNothingButItsParameters) {
  ALATE_NEEDS_SHARED_DATA("correction-points/set2.csv");
  const Site site = site_of("navigation: {alpha: [20, 10], beta: [15, 20], theta: 20}\n",
                            {"navigation.points=" + test::shared_data("correction-points/set2.csv").string()});
  EXPECT_EQ(site.navigation->points.size(), 325U);
  EXPECT_EQ(site.navigation->goal_id, 326);
  EXPECT_NEAR((site.mission.goal - site.mission.start).norm(), 103'045.12, 0.01);
}

}  // namespace
}  // namespace alate
