#include "alate/core/scenario.hpp"

#include <gtest/gtest.h>

namespace alate {
namespace {

TEST(MarkOf, FindsTheFieldOrTheNearestGroupAroundIt) {
  Scenario scenario;
  scenario.file = "a.yaml";
  scenario.marks = {{"threats.0", {"a.yaml", 3, 5}}, {"threats.0.level", {"--override", 0, 0}}};
  EXPECT_EQ(mark_of(scenario, "threats.0.level").file, "--override");
  EXPECT_EQ(mark_of(scenario, "threats.0.radius_m").line, 3);
  EXPECT_EQ(mark_of(scenario, "threats.0.cylinder.top_m").column, 5);
  EXPECT_EQ(mark_of(scenario, "threats").file, "a.yaml");
  EXPECT_EQ(mark_of(scenario, "threats").line, 0);
}

TEST(Scenario, ComparesWhatWasAskedNotWhereItStood) {
  Scenario a;
  Scenario b;
  b.file = "b.yaml";
  b.marks["goal"] = {"b.yaml", 1, 1};
  EXPECT_EQ(a, b);
  b.goal.tolerance_m = 1;
  EXPECT_NE(a, b);
}

}  // namespace
}  // namespace alate
