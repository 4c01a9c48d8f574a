// Maps, verdicts from results made by hand, and a small reproduction.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "out/xml_balance.hpp"
#include "study/judgement.hpp"
#include "study/yin2021/claims.hpp"
#include "study/yin2021/defects.hpp"
#include "study/yin2021/reproduction.hpp"

namespace alate::yin2021 {
namespace {

constexpr std::size_t kFewMaps = 4;
constexpr std::size_t kHistory = 12;

/// Which route is the best after an iteration.
struct At {
  std::size_t map = 0;
  std::size_t run = 0;
  std::size_t iteration = 0;  ///< From 1.
};
using Told = std::function<GridMeasures(const At&)>;

GridMeasures measures(double length, double height_dev = 0.5, std::size_t turns = 10) {
  return {.length_cells = length, .height_deviation_m = height_dev, .turns = turns};
}

/// Every run of a method whose name begins so tells these measures.
void tell(Study& study, std::string_view method, const Told& told) {
  for (SizeStudy& of_size : study.sizes) {
    for (Experiment* experiment : {&of_size.main, &of_size.readings}) {
      for (Trial& trial : experiment->trials) {
        if (!experiment->methods[trial.method_index].name.starts_with(method)) continue;
        for (std::size_t r = 0; r < trial.runs.size(); ++r) {
          StudyRun& run = trial.runs[r];
          run.passed = true;
          run.plan.history.clear();
          for (std::size_t i = 1; i <= kHistory; ++i) {
            const GridMeasures best = told({.map = trial.case_index, .run = r, .iteration = i});
            run.plan.history.push_back({.grid = GridStats{.best = best, .mean_score = composite_index(best) + 5}});
          }
          run.metrics.grid = run.plan.history.back().grid->best;
          run.metrics.cost = run.metrics.grid->length_cells;
        }
      }
    }
  }
}

/// Both methods alike, maps apart.
Study made_up() {
  Study study = plan_study({.seeds = 6}, kFewMaps);
  for (const char* method : {kLi, kYin})
    tell(study, method, [](const At& at) { return measures(40 + static_cast<double>(at.map)); });
  return study;
}

Claim claim(const Study& study, const std::string& id) {
  const auto all = claims(study);
  const auto found = std::ranges::find(all, id, &Claim::id);
  EXPECT_NE(found, all.end()) << id;
  return found == all.end() ? Claim{} : *found;
}

TEST(Yin2021Maps, HaveAWayAndKeepTheirSeeds) {
  const Maps maps = draw_maps(kLarge, 6);
  ASSERT_EQ(maps.seeds.size(), 6U);
  EXPECT_EQ(static_cast<std::size_t>(maps.seeds.back()), 6 + maps.passed_over);
  EXPECT_GT(maps.passed_over, 0U);
  for (std::size_t i = 0; i < maps.seeds.size(); ++i) {
    const HeightGrid& grid = *maps.cases[i].site().grid;
    EXPECT_EQ(grid.columns, 30);
    EXPECT_FALSE(grid.blocked_at(0, 29));
    EXPECT_FALSE(grid.blocked_at(29, 0));
    EXPECT_FALSE(grid.height_m.empty());
    EXPECT_GE(maps.optimum[i], 29 * 1.41421);
  }
}

TEST(Yin2021Claims, OfMethodsThatAreAlike) {
  const Study study = made_up();
  EXPECT_EQ(claim(study, "length").verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(claim(study, "length").ours, 0);
  EXPECT_EQ(claim(study, "mean-length-10x10").verdict, ClaimVerdict::holds);
  EXPECT_EQ(claim(study, "turns-10x10").verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(claim(study, "variance").verdict, ClaimVerdict::cannot_be_told) << "no variance at all";
  EXPECT_EQ(claim(study, "equal-height").verdict, ClaimVerdict::cannot_be_told) << "no lengths that differ";
  EXPECT_NE(claim(study, "length").why.find("The same under every other reading."), std::string::npos);
}

TEST(Yin2021Claims, FollowTheLengths) {
  Study study = made_up();
  tell(study, kYin, [](const At& at) { return measures(0.9 * (40 + static_cast<double>(at.map))); });
  const Claim length = claim(study, "length");
  EXPECT_EQ(length.verdict, ClaimVerdict::holds);
  EXPECT_NEAR(*length.ours, -10, 1e-9);
  EXPECT_NE(length.why.find("4 of 4 maps"), std::string::npos) << length.why;
  EXPECT_EQ(claim(study, "mean-length-10x10").verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(claim(study, "first-length-30x30").verdict, ClaimVerdict::holds);
  EXPECT_EQ(claim(study, "first-length-10x10").verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(claim(study, "equal-height").verdict, ClaimVerdict::holds) << "F is made equal";
}

TEST(Yin2021Claims, FollowTheVariances) {
  Study study = made_up();
  const auto spread_by = [](double width) {
    return [=](const At& at) {
      return measures(40 + width * static_cast<double>(at.run) + 0.01 * static_cast<double>(at.map));
    };
  };
  tell(study, kLi, spread_by(1));
  tell(study, kYin, spread_by(0.25));
  const Claim smaller = claim(study, "variance");
  EXPECT_EQ(smaller.verdict, ClaimVerdict::holds);
  EXPECT_NEAR(*smaller.ours, 100 * (1.0 / 16 - 1), 1e-9);
  tell(study, kYin, spread_by(0.75));
  EXPECT_EQ(claim(study, "variance").verdict, ClaimVerdict::does_not_hold);
}

TEST(Yin2021Claims, NameReadingsWithAnotherVerdict) {
  Study study = made_up();
  tell(study, "Yin 2021, as coded", [](const At&) { return measures(35); });
  const Claim length = claim(study, "length");
  EXPECT_EQ(length.verdict, ClaimVerdict::does_not_hold);
  EXPECT_NE(length.why.find("it holds with: as coded."), std::string::npos) << length.why;
}

TEST(Yin2021Claims, FollowWhenHeightsSettle) {
  Study study = made_up();
  const auto settled_at = [](std::size_t last) {
    return [=](const At& at) {
      return measures(40, at.iteration < last ? 0.9 - 0.01 * static_cast<double>(at.iteration) : 0.5);
    };
  };
  tell(study, kYin, settled_at(4));
  tell(study, kLi, settled_at(8));
  EXPECT_EQ(claim(study, "height-10x10").verdict, ClaimVerdict::holds);
  EXPECT_EQ(*claim(study, "height-10x10").ours, 4);
  EXPECT_EQ(claim(study, "height-30x30").verdict, ClaimVerdict::does_not_hold) << "the baseline is within 10 too";
}

TEST(Yin2021Claims, FollowTheTurns) {
  Study study = made_up();
  const auto turning = [](std::size_t after_five) {
    return [=](const At& at) { return measures(40, 0.5, at.iteration > 5 ? after_five : 6); };
  };
  tell(study, kLi, turning(6));
  tell(study, kYin, turning(4));
  EXPECT_EQ(claim(study, "turns-curve-10x10").verdict, ClaimVerdict::holds);
  EXPECT_EQ(claim(study, "turns-10x10").verdict, ClaimVerdict::holds);
  EXPECT_NEAR(*claim(study, "turns-10x10").ours, -2, 1e-12);
  EXPECT_EQ(claim(study, "turns-30x30").verdict, ClaimVerdict::does_not_hold);
}

TEST(Yin2021Claims, WithoutRoutesCannotBeTold) {
  const Study study = plan_study({.seeds = 2}, 2);
  for (const Claim& each : claims(study)) {
    EXPECT_EQ(each.verdict, ClaimVerdict::cannot_be_told) << each.id;
    EXPECT_FALSE(each.ours) << each.id;
    EXPECT_FALSE(each.why.empty()) << each.id;
  }
}

TEST(Yin2021Judgement, NeedsIntervalsOnOneSide) {
  Effect effect{.what = "L", .unit = "%", .change = Interval{-3, -4, -2}, .hardly = 1};
  EXPECT_EQ(falls(effect).verdict, ClaimVerdict::holds);
  EXPECT_EQ(rises(effect).verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(hardly_changes(effect).verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(falls_to(effect, -3.5).verdict, ClaimVerdict::holds);
  EXPECT_EQ(falls_to(effect, -6.4).verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(falls(effect).words, "L: -3.00 % (-4.00 to -2.00).");
  effect.change = Interval{0, -8, 8};
  for (const ClaimPart& part : {falls(effect), rises(effect), hardly_changes(effect), falls_to(effect, -6.4)})
    EXPECT_EQ(part.verdict, ClaimVerdict::cannot_be_told) << part.words;
  effect.change = Interval{0, -0.5, 0.5};
  EXPECT_EQ(falls(effect).verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(hardly_changes(effect).verdict, ClaimVerdict::holds);
}

TEST(Yin2021Judgement, JoinsParts) {
  const ClaimPart holds{.words = "", .verdict = ClaimVerdict::holds};
  const ClaimPart fails{.words = "", .verdict = ClaimVerdict::does_not_hold};
  const ClaimPart open{.words = ""};
  EXPECT_EQ(all_of({holds, holds}), ClaimVerdict::holds);
  EXPECT_EQ(all_of({holds, open}), ClaimVerdict::cannot_be_told);
  EXPECT_EQ(all_of({holds, open, fails}), ClaimVerdict::does_not_hold);
  EXPECT_EQ(any_of({fails, holds}), ClaimVerdict::holds);
  EXPECT_EQ(any_of({fails, open}), ClaimVerdict::cannot_be_told);
  EXPECT_EQ(any_of({fails, fails}), ClaimVerdict::does_not_hold);
  EXPECT_EQ(all_of({}), ClaimVerdict::cannot_be_told);
}

/// The colony of the main reading measures as the check does; F as coded follows from the number of cells.
TEST(Yin2021Study, RunsAsRead) {
  Study study = plan_study({.seeds = 6, .iterations = 4}, kFewMaps);
  Executor executor(2);
  for (SizeStudy& of_size : study.sizes) {
    ASSERT_TRUE(run_experiments({&of_size.main, &of_size.readings}, executor, {}));
    for (const Trial& trial : of_size.main.trials) {
      for (const StudyRun& run : trial.runs) {
        ASSERT_TRUE(run.passed);
        EXPECT_NEAR(run.plan.history.back().grid->best.length_cells, run.metrics.grid->length_cells, 1e-9);
        EXPECT_NEAR(run.plan.history.back().grid->best.height_deviation_m, run.metrics.grid->height_deviation_m, 1e-9);
        EXPECT_EQ(run.plan.history.back().grid->best.turns, run.metrics.grid->turns);
        EXPECT_GE(run.metrics.cost, of_size.maps.optimum[trial.case_index] * (1 - 1e-12));
      }
    }
  }
  for (const Size size : kBoth) {
    const CodedHeights coded = coded_heights(study, size);
    EXPECT_TRUE(coded.by_count_alone);
    EXPECT_GT(coded.counts, 1U);
    EXPECT_LT(coded.counts, coded.runs);
  }
}

nlohmann::json reproduced(int threads) {
  Executor executor(threads);
  const auto result = reproduce(executor, {.seeds = 1, .iterations = 2});
  EXPECT_TRUE(result);
  EXPECT_EQ(test::xml_fault(result->page), "");
  for (const char* part : {"What must be known first", "Every reading", "Map by map", "Over the iterations",
                           "Best routes", "The height deviation is taken over the wrong cells"})
    EXPECT_NE(result->page.find(part), std::string::npos) << part;
  EXPECT_NE(to_text(*result).find("states no test of significance"), std::string::npos);
  nlohmann::json json = nlohmann::json::parse(to_json(*result));
  for (const char* key : {"cells", "details"})
    for (auto& cell : json[key]) cell.erase("wall_s");
  json["settings"].erase("threads");
  return json;
}

TEST(Yin2021, SaysTheSameAtAnyNumberOfThreads) {
  const nlohmann::json json = reproduced(3);
  EXPECT_EQ(json, reproduced(1));
  EXPECT_EQ(json.at("claims").size(), 13U);
  EXPECT_EQ(json.at("notes").size(), 6U);
  EXPECT_EQ(json.at("details").size(), 2 * kMaps * main_methods({}).size());
  EXPECT_EQ(json.at("cells").size(), 2 * (main_methods({}).size() + reading_methods({}).size()));
  for (const auto& cell : json.at("details")) {
    if (cell.at("best").is_null()) continue;
    EXPECT_GE(cell.at("best"), cell.at("lower_bound").get<double>() * (1 - 1e-12));
  }
}

TEST(Yin2021, NothingIsShownOfAnInterruptedStudy) {
  std::stop_source source;
  source.request_stop();
  Executor executor(1);
  ReproduceOptions options{.seeds = 1, .iterations = 1};
  options.stop = source.get_token();
  EXPECT_FALSE(reproduce(executor, options));
}

}  // namespace
}  // namespace alate::yin2021
