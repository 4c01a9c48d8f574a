#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "support.hpp"

namespace alate {
namespace {

using Json = nlohmann::ordered_json;
using test::Flight;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  return names;
}

TEST(ResultJson, HasEveryKeyOfTheContract) {
  Flight flight;
  flight.find_route();
  const Json json = Json::parse(to_json(flight.result));
  for (const char* key :
       {"schema",     "alate",    "scenario",     "outcome",  "stop",        "planner", "preset",  "chosen_by", "why",
        "parameters", "seed",     "reproducible", "cost",     "lower_bound", "gap",     "metrics", "verdict",   "route",
        "front",      "counters", "files",        "warnings", "overrides",   "ground",  "notice"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(keys(json["metrics"]),
            (std::vector<std::string>{"length_m", "climb_m", "descent_m", "threat", "min_clearance_m", "corrections",
                                      "probability", "height_dev", "turns", "composite"}));
  EXPECT_EQ(keys(json["verdict"]), (std::vector<std::string>{"status", "ok", "violations", "margins", "not_checked"}));
  EXPECT_EQ(keys(json["route"][0]), (std::vector<std::string>{"x_m", "y_m", "z_m", "lat", "lon", "agl_m", "leg", "arc",
                                                              "point_id", "actions"}));
  for (const char* key : {"candidates", "iterations", "wall_s"}) EXPECT_TRUE(json["counters"].contains(key)) << key;
  EXPECT_EQ(json["scenario"], "flights/hill.yaml");
  EXPECT_EQ(json["overrides"][0], "terrain.clearance_m=60");
  EXPECT_EQ(json["parameters"]["width"], 64);
  EXPECT_DOUBLE_EQ(json["gap"], 0.105);
}

TEST(ResultJson, WritesStatesAsFlown) {
  Flight flight;
  flight.find_route();
  RouteState arc{.position = {9100, 7100, 200}, .leg = LegKind::arc};
  arc.arc = Arc{.center = {9100, 7000}, .radius_m = 100, .angle_rad = kPi / 2};
  flight.result.plan.route.states.push_back(arc);
  const Json route = Json::parse(to_json(flight.result))["route"];
  ASSERT_EQ(route.size(), 5U);
  EXPECT_EQ(route[0]["leg"], "start");
  EXPECT_TRUE(route[0]["actions"].is_null());
  EXPECT_DOUBLE_EQ(route[1]["actions"]["pitch_deg"], 3);
  EXPECT_EQ(route[3]["point_id"], 7);
  EXPECT_TRUE(route[3]["arc"].is_null());
  EXPECT_DOUBLE_EQ(route[4]["arc"]["angle_deg"], 90);
  EXPECT_NEAR(route[0]["agl_m"], 150, 1);
  EXPECT_NEAR(route[0]["lat"], 46.809, 0.001);
}

TEST(ResultJson, SaysNothingOfARouteThatIsNotThere) {
  Flight flight;
  flight.result.plan.why = "a ridge bars the way";
  const Json json = Json::parse(to_json(flight.result));
  EXPECT_EQ(json["outcome"], "none_found");
  EXPECT_EQ(json["route"], Json::array());
  EXPECT_EQ(json["front"], Json::array());
  for (const char* key : {"cost", "gap"}) EXPECT_TRUE(json[key].is_null()) << key;
  for (const auto& [key, value] : json["metrics"].items()) EXPECT_TRUE(value.is_null()) << key;
  EXPECT_TRUE(json["verdict"]["status"].is_null());
  EXPECT_EQ(json["verdict"]["ok"], false);
  EXPECT_NE(json["summary"].get<std::string>().find("a ridge bars the way"), std::string::npos);
}

TEST(ResultJson, WritesNullForWhatIsNoNumber) {
  Flight flight;
  flight.find_route();
  flight.result.metrics.threat = kNan;
  flight.result.metrics.min_clearance_m = kInfinity;
  flight.result.verdict.violations = {{.rule = "bounds", .where = {kNan, 0, 0}, .value = -kInfinity, .unit = "m"}};
  const Json json = Json::parse(to_json(flight.result));
  EXPECT_TRUE(json["metrics"]["threat"].is_null());
  EXPECT_TRUE(json["metrics"]["min_clearance_m"].is_null());
  EXPECT_TRUE(json["verdict"]["violations"][0]["value"].is_null());
  EXPECT_TRUE(json["verdict"]["violations"][0]["where"]["x_m"].is_null());
}

TEST(ResultJson, LeavesOutPlacesInALocalFrame) {
  Flight flight;
  flight.find_route();
  flight.site.frame = Frame::local();
  const Json json = Json::parse(to_json(flight.result));
  EXPECT_TRUE(json["route"][0]["lat"].is_null());
  EXPECT_TRUE(json["verdict"]["margins"][0]["where"]["lon"].is_null());
}

TEST(ResultJson, SurvivesBytesThatAreNotText) {
  Flight flight;
  flight.site.scenario.file = "a\xFF\"b";
  flight.site.warnings = {"\xC0"};
  const Json json = Json::parse(to_json(flight.result));
  EXPECT_NE(json["scenario"].get<std::string>().find("\xEF\xBF\xBD\"b"), std::string::npos);
}

TEST(ResultJson, HasNoGapWithoutABound) {
  Flight flight;
  flight.find_route();
  flight.result.plan.lower_bound = 0;
  EXPECT_FALSE(gap(flight.result).has_value());
  EXPECT_TRUE(Json::parse(to_json(flight.result))["gap"].is_null());
}

TEST(ResultJson, TellsEachWarningOnce) {
  Flight flight;
  flight.site.warnings = {"voids", "voids"};
  flight.result.warnings = {"voids", "late"};
  EXPECT_EQ(Json::parse(to_json(flight.result))["warnings"], (Json{"voids", "late"}));
}

TEST(ErrorsJson, ListsEveryFault) {
  const Json json = Json::parse(to_json(std::vector<Fault>{{.file = "a.yaml",
                                                            .line = 3,
                                                            .column = 5,
                                                            .field = "threats.0.radius_m",
                                                            .value = "-1",
                                                            .limit = "> 0",
                                                            .unit = "m",
                                                            .message = "must be positive"},
                                                           {.field = "--out", .message = "is not a folder"}}));
  EXPECT_EQ(json["schema"], 1);
  ASSERT_EQ(json["errors"].size(), 2U);
  EXPECT_EQ(keys(json["errors"][0]),
            (std::vector<std::string>{"file", "line", "column", "field", "value", "limit", "unit", "message"}));
  EXPECT_EQ(json["errors"][0]["line"], 3);
  EXPECT_TRUE(json["errors"][1]["line"].is_null());
  EXPECT_TRUE(json["errors"][1]["file"].is_null());
}

TEST(CheckJson, HoldsVerdictAndMetrics) {
  Flight flight;
  flight.find_route();
  flight.result.verdict.status = Status::unknown;
  const Json json = Json::parse(to_json(flight.site, flight.result.verdict, flight.result.metrics));
  EXPECT_EQ(json["verdict"]["status"], "unknown");
  EXPECT_EQ(json["verdict"]["ok"], false);
  EXPECT_EQ(json["verdict"]["not_checked"][0]["rule"], "zone");
  EXPECT_DOUBLE_EQ(json["metrics"]["length_m"], 11000);
  EXPECT_TRUE(json.contains("notice"));
}

TEST(Summary, SaysWhetherTheRouteMayBeFlown) {
  Flight flight;
  flight.find_route();
  EXPECT_EQ(summary(flight.result),
            "A route of 11.0 km was found that keeps all 1 rules that were judged. Its cost is at most 10.5 % above "
            "the best possible.");
  flight.result.verdict.status = Status::fail;
  flight.result.verdict.violations = {{.rule = "turn"}, {.rule = "turn"}, {.rule = "climb"}};
  EXPECT_EQ(summary(flight.result), "A route of 11.0 km was found, but it must not be flown: it breaks turn, climb.");
  flight.result.verdict.status = Status::unknown;
  flight.result.verdict.not_checked = {{.rule = "terrain_clearance", .why = "voids", .unknown = true}};
  EXPECT_EQ(summary(flight.result),
            "A route of 11.0 km was found, but the data do not reach far enough to judge terrain_clearance.");
}

TEST(Summary, TellsCorrectionsAndChances) {
  Flight flight;
  flight.find_route();
  flight.site.navigation = Navigation{.points = {{.id = 1}}};
  flight.result.metrics.corrections = 1;
  flight.result.metrics.probability = 1;
  const std::string start = "A route of 11.0 km with 1 correction was found that keeps all 1 rules that were judged. ";
  EXPECT_EQ(summary(flight.result), start + "Its cost is at most 10.5 % above the best possible.");
  flight.site.navigation->points[0].success = 0.8;
  EXPECT_TRUE(summary(flight.result).ends_with(" It succeeds even if every correction that may fail does."));
  flight.result.metrics.probability = 0.99999;
  EXPECT_TRUE(summary(flight.result).ends_with(" As corrections may fail, it succeeds with a chance of 99.9 %."));
}

TEST(Summary, TellsTheFront) {
  Flight flight;
  flight.find_route();
  flight.result.plan.front = {{.length_m = 12000, .corrections = 1}, {.length_m = 11000, .corrections = 2}};
  EXPECT_TRUE(summary(flight.result)
                  .ends_with(" 2 best trade-offs are known: 1 correction over 12.0 km; 2 corrections over 11.0 km."));
  flight.result.plan.front.resize(6, {.length_m = 10000, .corrections = 3, .probability = 0.5});
  EXPECT_TRUE(summary(flight.result)
                  .ends_with("1 correction over 12.0 km (100 %); 2 corrections over 11.0 km (100 %); 3 corrections "
                             "over 10.0 km (50.0 %); 3 corrections over 10.0 km (50.0 %); and 2 more."));
}

TEST(ResultJson, HoldsTheFrontAndWhatPointsDo) {
  Flight flight;
  flight.find_route();
  EXPECT_TRUE(Json::parse(to_json(flight.result))["metrics"]["corrections"].is_null());
  flight.result.metrics.corrections = 3;
  flight.result.metrics.probability = 0.5;
  flight.result.plan.front = {{.length_m = 12000, .corrections = 1, .probability = 0.25, .points = {503, 294}}};
  const Json json = Json::parse(to_json(flight.result));
  EXPECT_EQ(json["metrics"]["corrections"], 3);
  EXPECT_EQ(json["metrics"]["probability"], 0.5);
  const Json front = {{{"length_m", 12000.0}, {"corrections", 1}, {"probability", 0.25}, {"points", {503, 294}}}};
  EXPECT_EQ(json["front"], front);
}

}  // namespace
}  // namespace alate
