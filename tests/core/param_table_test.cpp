#include "alate/core/param_table.hpp"

#include <gtest/gtest.h>

namespace alate {
namespace {

ParamTable table() {
  return ParamTable({{.name = "ants", .default_value = std::int64_t{20}, .min = 1, .max = 1000},
                     {.name = "evaporation", .unit = "1/s", .default_value = 0.1, .min = 0, .max = 1},
                     {.name = "local_search", .default_value = true},
                     {.name = "score", .default_value = std::string("J"), .choices = {"J", "J+h"}}});
}

ParamSetting setting(const std::string& name, const std::string& text) {
  return {.name = name, .text = text, .file = "--set"};
}

std::vector<Fault> faults_of(const std::string& name, const std::string& text) {
  std::vector<Fault> faults;
  table().resolve({}, {setting(name, text)}, faults);
  return faults;
}

TEST(ParamTable, DefaultsThenPresetThenSettings) {
  std::vector<Fault> faults;
  const ParamValues values =
      table().resolve({{"ants", std::int64_t{50}}, {"evaporation", 0.5}},
                      {setting("ants", "60"), setting("ants", "+70"), setting("local_search", "false")}, faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(values.integer("ants"), 70);
  EXPECT_EQ(values.number("evaporation"), 0.5);
  EXPECT_FALSE(values.flag("local_search"));
  EXPECT_EQ(values.text("score"), "J");
  EXPECT_EQ(values.all().size(), 4U);
}

TEST(ParamTable, AnOpenEndIsNotAllowedItself) {
  const ParamTable open({{.name = "share", .default_value = 0.5, .min = 0, .max = 1, .above_min = true}});
  std::vector<Fault> faults;
  open.resolve({}, {setting("share", "1"), setting("share", "1e-9")}, faults);
  EXPECT_TRUE(faults.empty());
  open.resolve({}, {setting("share", "0")}, faults);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].limit, "> 0, <= 1");
}

TEST(ParamTable, RangesIncludeTheirEnds) {
  for (const char* text : {"0", "1", "1e-3", "1."}) EXPECT_TRUE(faults_of("evaporation", text).empty()) << text;
  for (const char* text : {"-0.001", "1.001"}) {
    const auto faults = faults_of("evaporation", text);
    ASSERT_EQ(faults.size(), 1U) << text;
    EXPECT_EQ(to_string(faults[0]),
              "--set: evaporation: out of range (got " + std::string(text) + ", allowed 0 to 1 1/s)");
  }
}

TEST(ParamTable, RefusesWrongTypes) {
  const std::vector<std::pair<const char*, const char*>> wrong{
      {"ants", "1.5"},        {"ants", "ten"},
      {"ants", ""},           {"ants", "010"},
      {"ants", "0"},          {"ants", "1e2"},
      {"evaporation", "nan"}, {"evaporation", "inf"},
      {"evaporation", "x"},   {"evaporation", "0,5"},
      {"score", "h"},         {"local_search", "yes"},
      {"ants", "9e99"},       {"ants", "99999999999999999999"}};
  for (const auto& [name, text] : wrong) EXPECT_EQ(faults_of(name, text).size(), 1U) << name << "=" << text;
}

TEST(ParamTable, CollectsEveryFaultAndStaysComplete) {
  std::vector<Fault> faults;
  ParamSetting unknown = setting("evaporatoin", "1");
  unknown.line = 4;
  const ParamValues values = table().resolve({}, {unknown, setting("score", "K")}, faults);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].message, "unknown parameter; did you mean evaporation?");
  EXPECT_EQ(faults[0].line, 4);
  EXPECT_EQ(faults[1].limit, "J | J+h");
  EXPECT_EQ(values.text("score"), "J");
}

TEST(Nearest, FindsSlipsAndMissingUnits) {
  const std::vector<std::string> keys{"radius_m", "level", "core_m", "lat", "lon", "length"};
  EXPECT_EQ(nearest("raduis_m", keys), "radius_m");
  EXPECT_EQ(nearest("radius", keys), "radius_m");
  EXPECT_EQ(nearest("lat_deg", keys), "lat");
  EXPECT_EQ(nearest("lenght", keys), "length");
  EXPECT_EQ(nearest("lvl", keys), "");
  EXPECT_EQ(nearest("colour", keys), "");
  EXPECT_EQ(nearest("", keys), "");
}

TEST(ParamValue, TextReadsBack) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(true), "true");
  EXPECT_EQ(to_text(std::int64_t{-3}), "-3");
  EXPECT_EQ(to_text(std::string("J+h")), "J+h");
}

}  // namespace
}  // namespace alate
