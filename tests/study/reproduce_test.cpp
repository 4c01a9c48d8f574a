#include "alate/study/reproduce.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "alate/core/fault.hpp"
#include "alate/data/scenario_file.hpp"
#include "out/xml_balance.hpp"
#include "study/konatowski2019/paper.hpp"

namespace alate {
namespace {

using Json = nlohmann::json;

/// Enough to have every part, too little to say anything.
const ReproduceOptions kShort{.seeds = 2, .iterations = 4};

Reproduction reproduced(int threads) {
  Executor executor(threads);
  auto result = reproduce("konatowski2019", executor, kShort);
  EXPECT_TRUE(result);
  return result.value_or(Reproduction{});
}

/// One result that several tests look at.
const Reproduction& once() {
  static const Reproduction kResult = reproduced(3);
  return kResult;
}

/// Without what may differ from run to run.
Json lasting(const Reproduction& result) {
  Json json = Json::parse(to_json(result));
  for (Json& cell : json["cells"]) cell.erase("wall_s");
  json["settings"].erase("threads");
  return json;
}

TEST(Reproduce, SaysTheSameAtAnyNumberOfThreads) { EXPECT_EQ(lasting(reproduced(1)), lasting(once())); }

TEST(Reproduce, HoldsEveryPartOfTheContract) {
  const Json json = Json::parse(to_json(once()));
  EXPECT_EQ(json.at("paper"), "konatowski2019");
  std::set<std::string> ids;
  for (const Json& claim : json.at("claims")) {
    for (const char* key : {"id", "text", "published", "ours", "unit", "verdict", "why"})
      EXPECT_TRUE(claim.contains(key)) << key;
    EXPECT_FALSE(claim.at("why").get<std::string>().empty());
    EXPECT_TRUE(ids.insert(claim.at("id")).second) << claim.at("id");
  }
  for (const char* kind : {"initial", "best", "gain"})
    for (const char* fuel : {"0.2", "0.5", "0.8"}) EXPECT_TRUE(ids.contains(std::string(kind) + "-" + fuel));
  std::set<std::string> methods;
  for (const Json& cell : json.at("cells")) {
    for (const char* key : {"case", "method", "runs", "mean", "sd", "best", "lower_bound", "wall_s"})
      EXPECT_TRUE(cell.contains(key)) << key;
    methods.insert(cell.at("method"));
    if (!cell.at("best").is_null()) {
      EXPECT_GE(cell.at("best"), cell.at("lower_bound"));
    }
  }
  EXPECT_EQ(json.at("cells").size(), 9 * methods.size() + 5);
  EXPECT_EQ(methods.size(), 11U);
  EXPECT_TRUE(json.at("settings").contains("processor"));
}

TEST(Reproduce, PageStandsAlone) {
  const Reproduction& result = once();
  EXPECT_EQ(test::xml_fault(result.page), "");
  for (const char* outside : {"http:", "https:", "<script", "url(", "src=", "@import", "javascript:"})
    EXPECT_EQ(result.page.find(outside), std::string::npos) << outside;
  for (const char* part : {"Layout A", "Layout C", "Layout F", "Convergence", "44.1", "109.97", "cannot be told"})
    EXPECT_NE(result.page.find(part), std::string::npos) << part;
  EXPECT_LT(result.page.size(), 2'000'000U);
}

TEST(Reproduce, TextNamesClaimsAndRuns) {
  const std::string text = to_text(once());
  for (const char* part : {"The stated gains follow from the stated costs", "A-0.2", "guided", "processor"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(Reproduce, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  Executor executor(2);
  ReproduceOptions options = kShort;
  options.stop = stop.get_token();
  EXPECT_FALSE(reproduce("konatowski2019", executor, options));
}

TEST(Reproduce, TellsHowFarItIs) {
  Executor executor(3);
  ReproduceOptions options = kShort;
  std::vector<double> fractions;
  options.on_progress = [&](const Progress& progress) { fractions.push_back(progress.fraction); };
  ASSERT_TRUE(reproduce("konatowski2019", executor, options));
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  ASSERT_FALSE(fractions.empty());
  EXPECT_DOUBLE_EQ(fractions.back(), 1);
}

TEST(Reproduce, UnknownPaperNamesTheNearest) {
  Executor executor(1);
  try {
    reproduce("konatowski2018", executor, {});
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean konatowski2019?"), std::string::npos) << error.what();
  }
}

/// What the program carries is what the examples say, planner apart.
TEST(Layouts, AreThoseOfTheExamples) {
  const std::filesystem::path folder = std::filesystem::path(ALATE_SOURCE_DIR) / "examples/konatowski2019";
  for (const auto& layout : konatowski2019::layouts()) {
    std::string name = layout.name;
    name[0] = static_cast<char>(std::tolower(name[0]));
    Scenario example = load_scenario((folder / (name + ".yaml")).string());
    example.planner.reset();
    Scenario own = parse_scenario(layout.scenario, "layout");
    ASSERT_EQ(example.threats.size(), own.threats.size());
    for (std::size_t i = 0; i < own.threats.size(); ++i) example.threats[i].name = own.threats[i].name;
    example.objective.fuel = own.objective.fuel;
    example.objective.threat = own.objective.threat;
    EXPECT_TRUE(example == own) << layout.name << "\n" << to_yaml(example) << to_yaml(own);
  }
}

}  // namespace
}  // namespace alate
