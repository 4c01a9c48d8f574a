// Routes over a grid: one change at a time breaks one rule, and the paper's measures.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "check/example.hpp"

namespace alate::test {
namespace {

/// Rows of `.` and `@`, the first in the north.
Site grid_site(const std::vector<std::string>& rows, double cell_m = 1) {
  Site site;
  site.grid =
      HeightGrid{.columns = static_cast<int>(rows[0].size()), .rows = static_cast<int>(rows.size()), .cell_m = cell_m};
  for (const std::string& row : rows) {
    for (const char letter : row) site.grid->blocked.push_back(letter == '@' ? 1 : 0);
  }
  return site;
}

/// Through the centres of cells (column, row), or places between them in halves.
Route through(Site& site, const std::vector<std::array<double, 2>>& cells) {
  std::vector<Vec3> positions;
  for (const auto& [column, row] : cells)
    positions.emplace_back(site.grid->origin.x() + (column + 0.5) * site.grid->cell_m,
                           site.grid->origin.y() + (site.grid->rows - 1 - row + 0.5) * site.grid->cell_m,
                           site.grid->level_m);
  site.mission.start = positions.front();
  site.mission.goal = positions.back();
  site.mission.tolerance_m = 1e-6;
  return make_route(positions);
}

const std::vector<std::string> kRows{"....",  //
                                     ".@..",  //
                                     "..@.",  //
                                     "...."};

struct Case {
  std::string name;
  std::vector<std::array<double, 2>> cells;
  std::set<std::string> broken;
  std::set<std::size_t> legs;
};

void PrintTo(const Case& route, std::ostream* out) { *out << route.name; }

const std::vector<Case> kCases{
    {"Around", {{0, 3}, {1, 3}, {3, 3}, {3, 0}}, {}, {}},
    {"DiagonalInTheOpen", {{2, 1}, {3, 0}}, {}, {}},
    {"LongDiagonalBesideNothing", {{0, 2}, {1, 3}}, {}, {}},
    {"BetweenTwoBlockedCorners", {{1, 2}, {2, 1}}, {"terrain_clearance"}, {1}},
    {"PastOneBlockedCorner", {{0, 1}, {1, 0}}, {"terrain_clearance"}, {1}},
    {"ThroughABlockedCell", {{0, 1}, {3, 1}}, {"terrain_clearance"}, {1}},
    {"ShallowLineThroughACorner", {{0, 0.9}, {3, 0.3}}, {"terrain_clearance"}, {1}},
    {"AnyAngleThatMisses", {{2, 0}, {3, 2}}, {}, {}},
    {"AlongASideOfABlockedCell", {{0, 0.5}, {3, 0.5}}, {}, {}},
    {"AlongSidesThatChange", {{1.5, 0}, {1.5, 3}}, {"terrain_clearance"}, {1}},
    {"CornerHiddenInAJoint", {{1, 2}, {1.5, 1.5}, {2, 1}}, {"terrain_clearance"}, {2}},
    {"CornerHiddenInARepeatedJoint", {{1, 2}, {1.5, 1.5}, {1.5, 1.5}, {2, 1}}, {"terrain_clearance"}, {3}},
    {"OutOfTheGrid", {{0, 0}, {-2, 0}, {0, 2}}, {"bounds"}, {1, 2}},
    {"AlongTheBorder", {{-0.5, 0}, {-0.5, 3}}, {}, {}},
};

class GridRoute : public testing::TestWithParam<Case> {};

TEST_P(GridRoute, BreaksItsRuleAndNoOther) {
  for (const double cell_m : {1.0, 0.1, 7.3}) {
    Site site = grid_site(kRows, cell_m);
    const Verdict verdict = check(site, through(site, GetParam().cells));
    EXPECT_EQ(broken_rules(verdict), GetParam().broken) << cell_m;
    EXPECT_EQ(broken_legs(verdict), GetParam().legs) << cell_m;
    ASSERT_NE(find_margin(verdict, "terrain_clearance"), nullptr);
    ASSERT_NE(find_margin(verdict, "bounds"), nullptr);
  }
}

TEST_P(GridRoute, WhereverTheGridLies) {
  Site site = grid_site(kRows, 90);
  site.grid->origin = Vec2(731'340, 4'004'820);
  site.grid->level_m = 650;
  const Verdict verdict = check(site, through(site, GetParam().cells));
  EXPECT_EQ(broken_rules(verdict), GetParam().broken);
  EXPECT_EQ(broken_legs(verdict), GetParam().legs);
  for (const Violation& violation : verdict.violations) {
    if (violation.rule == "terrain_clearance") {
      EXPECT_TRUE(site.grid->area().contains(violation.where.head<2>()));
    }
  }
}

TEST_P(GridRoute, BackwardsTheSame) {
  Site site = grid_site(kRows);
  std::vector<std::array<double, 2>> cells = GetParam().cells;
  std::ranges::reverse(cells);
  EXPECT_EQ(broken_rules(check(site, through(site, cells))), GetParam().broken);
}

INSTANTIATE_TEST_SUITE_P(Each, GridRoute, testing::ValuesIn(kCases),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(Grid, OneMoreBlockedCellBreaksAGoodRoute) {
  for (const auto& [column, row, broken] :
       {std::array{1, 3, 1}, {2, 3, 1}, {3, 1, 1}, {3, 3, 1}, {0, 0, 0}, {2, 1, 0}}) {
    Site site = grid_site(kRows);
    const Route route = through(site, {{0, 2}, {0, 3}, {3, 3}, {3, 0}});
    ASSERT_TRUE(check(site, route).ok());
    site.grid->blocked[site.grid->index(column, row)] = 1;
    EXPECT_EQ(broken_rules(check(site, route)),
              broken == 1 ? std::set<std::string>{"terrain_clearance"} : std::set<std::string>{})
        << column << " " << row;
  }
}

TEST(Grid, AlongTheSideOfTwoBlockedCells) {
  Site site = grid_site({"@..", "@..", "..."});
  EXPECT_TRUE(check(site, through(site, {{0.5, 2}, {0.5, 0}})).ok());
  site = grid_site({"@@.", "@@.", "..."});
  EXPECT_EQ(broken_rules(check(site, through(site, {{0.5, 2}, {0.5, 0}}))), std::set<std::string>{"terrain_clearance"});
}

TEST(Grid, StandingStill) {
  Site site = grid_site(kRows);
  EXPECT_TRUE(check(site, through(site, {{0, 0}})).ok());
  EXPECT_EQ(broken_rules(check(site, through(site, {{1, 1}}))), std::set<std::string>{"terrain_clearance"});
  EXPECT_EQ(broken_rules(check(site, through(site, {{1, 1}, {1, 1}}))), std::set<std::string>{"terrain_clearance"});
  EXPECT_EQ(broken_rules(check(site, through(site, {{9, 9}}))), std::set<std::string>{"bounds"});
  site.grid->cell_m = 0.01;
  EXPECT_EQ(broken_rules(check(site, through(site, {{9e9, -9e9}}))), std::set<std::string>{"bounds"});
}

TEST(Grid, AChainOfTinyStepsHidesNothing) {
  Site site = grid_site(kRows, 0.01);
  std::vector<std::array<double, 2>> cells;
  for (int i = 0; i <= 40'000; ++i) cells.push_back({i * 3.0 / 40'000, 1});
  EXPECT_EQ(broken_rules(check(site, through(site, cells))), std::set<std::string>{"terrain_clearance"});
}

TEST(Grid, FarAwayEndsSoon) {
  Site site = grid_site(kRows);
  const Route route = through(site, {{0, 0}, {9e7, 9e7}, {-9e7, 5}, {0, 0}});
  EXPECT_TRUE(broken_rules(check(site, route)).contains("bounds"));
}

/// Is a place within `slack` of it in a blocked cell?
bool near_blocked(const HeightGrid& grid, const Vec2& at, double slack) {
  for (const double dx : {-slack, slack}) {
    for (const double dy : {-slack, slack}) {
      const int column = static_cast<int>(std::floor(at.x() + dx));
      const int row = grid.rows - 1 - static_cast<int>(std::floor(at.y() + dy));
      if (grid.contains(column, row) && grid.blocked_at(column, row)) return true;
    }
  }
  return false;
}

TEST(Grid, AgreesWithSamplesOnRandomLegs) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> wide(0, 9);
  std::uniform_real_distribution<double> high(0, 8);
  std::size_t broken = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::string> rows(8, std::string(9, '.'));
    for (std::string& row : rows) {
      for (char& letter : row) letter = random() % 8 == 0 ? '@' : '.';
    }
    const Site site = grid_site(rows);
    const Segment leg{{wide(random), high(random), 0}, {wide(random), high(random), 0}};
    bool enters = false;
    bool comes_near = false;
    for (int i = 0; i <= 4000; ++i) {
      const Vec2 at = leg.at(i / 4000.0).head<2>();
      enters = enters || near_blocked(*site.grid, at, 0);
      comes_near = comes_near || near_blocked(*site.grid, at, 0.01);
    }
    const bool found = broken_rules(check(site, make_route({leg.a, leg.b}))).contains("terrain_clearance");
    broken += found ? 1 : 0;
    EXPECT_TRUE(found || !enters) << round;
    EXPECT_TRUE(comes_near || !found) << round;
  }
  EXPECT_GT(broken, 500U);
  EXPECT_LT(broken, 2500U);
}

TEST(GridMeasures, CountsTurnsAndHeights) {
  Site site = grid_site(kRows, 10);
  site.grid->height_m = {0, 0, 0, 5, 0, 0, 0, 7, 0, 0, 0, 9, 1, 2, 3, 4};
  const Metrics metrics = measure(site, through(site, {{0, 3}, {1, 3}, {2, 3}, {3, 2}, {3, 1}, {3, 0}}));
  ASSERT_TRUE(metrics.grid);
  EXPECT_NEAR(metrics.grid->length_cells, 4 + std::sqrt(2), 1e-12);
  EXPECT_NEAR(metrics.length_m, 10 * (4 + std::sqrt(2)), 1e-9);
  EXPECT_EQ(metrics.grid->turns, 2U);
  // Heights 1 2 3 9 7 5: mean 4.5, squares 12.25 + 6.25 + 2.25 + 20.25 + 6.25 + 0.25 = 47.5.
  EXPECT_NEAR(metrics.grid->height_deviation_m, std::sqrt(47.5 / 5), 1e-12);
  EXPECT_NEAR(composite_index(*metrics.grid), 4 + std::sqrt(2) + 100 * std::sqrt(47.5 / 5) + 2, 1e-9);
}

TEST(GridMeasures, LongLegsPassTheSameCells) {
  Site site = grid_site(kRows);
  site.grid->height_m = {0, 0, 0, 5, 0, 0, 0, 7, 0, 0, 0, 9, 1, 2, 3, 4};
  const Metrics steps = measure(site, through(site, {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {3, 2}, {3, 1}, {3, 0}}));
  const Metrics legs = measure(site, through(site, {{0, 3}, {3, 3}, {3, 0}}));
  EXPECT_NEAR(composite_index(*steps.grid), composite_index(*legs.grid), 1e-9);
  EXPECT_EQ(legs.grid->turns, 1U);
}

TEST(GridMeasures, OnlyWithAGrid) { EXPECT_FALSE(measure(example_site(), example_route()).grid); }

}  // namespace
}  // namespace alate::test
