#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "data/scenario_samples.hpp"

namespace alate {
namespace {

/// Random scenarios that obey the rules, seeded.
class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  Scenario scenario() {
    Scenario s;
    frame(s.frame);
    const bool placed = s.frame.local || s.frame.origin;
    if (coin()) s.terrain = terrain(placed);
    if (!s.terrain && !s.frame.origin && s.frame.crs == "auto" && coin()) s.grid = grid();
    s.start.place = place(s);
    maybe(s.start.heading_deg, -360, 360);
    s.goal = {.place = place(s), .tolerance_m = number(0, 1000)};
    s.vehicle = vehicle();
    for (int i = pick(4); i > 0; --i) s.threats.push_back(threat(s));
    objective(s.objective);
    if (!s.grid && coin()) s.navigation = navigation(s);
    if (coin())
      s.planner = PlannerSpec{.name = word(), .preset = coin() ? word() : "", .parameters = {{word(), word()}}};
    return s;
  }

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool coin() { return pick(2) == 0; }
  /// All magnitudes and digits; sometimes round.
  double number(double min, double max) {
    const double value = std::uniform_real_distribution(min, max)(random_);
    return coin() ? value : std::clamp(std::round(value), min, max);
  }
  double positive() { return std::pow(10.0, number(-8, 8)); }
  template <std::size_t N>
  std::array<double, N> position() {
    std::array<double, N> values{};
    for (double& value : values) value = number(-1e6, 1e6);
    return values;
  }
  void maybe(std::optional<double>& value, double min, double max) {
    if (coin()) value = number(min, max);
  }
  std::string word() {
    static const std::vector<std::string> kWords{
        "a",   "null", "~",  "true", "010", "1e5", "é日本", "a: b # c", "<script>", "'",    "\"",  "back\\slash",
        "- x", "{a}",  "*x", "&y",   "!!z", "%",   " s ",   "a\tb",     "@",        "=cmd", "---", "?"};
    return kWords[static_cast<std::size_t>(pick(static_cast<int>(kWords.size())))];
  }
  void frame(FrameSpec& frame) {
    const int kind = pick(4);
    if (kind == 1) frame.crs = "EPSG:32616";
    if (kind == 2) frame.origin = GeoPoint{number(-90, 90), number(-180, 180)};
    if (kind == 3) frame.local = true;
  }
  TerrainSpec terrain(bool placed) {
    TerrainSpec t;
    if (placed && coin()) {
      for (int i = pick(3); i >= 0; --i)
        t.peaks.push_back({.center_m = position<2>(), .height_m = positive(), .slope_m = {positive(), positive()}});
      t.combine = coin() ? PeakCombination::sum : PeakCombination::max;
      t.extent_m = {positive(), positive()};
    } else {
      t.dem = "folder/" + word();
    }
    t.clearance_m = number(0, 100);
    maybe(t.ceiling_agl_m, 101, 500);
    maybe(t.ceiling_amsl_m, -100, 5000);
    return t;
  }
  GridSpec grid() {
    GridSpec g{.heights = coin() ? GridHeights::flat : GridHeights::peaks, .cell_m = number(0.01, 10'000)};
    if (coin()) {
      g.map = "folder/" + word();
    } else {
      g.random =
          RandomGridSpec{.size = {1 + pick(4000), 1 + pick(4000)}, .obstacles = number(0, 1), .seed = pick(9999)};
    }
    return g;
  }
  PlaceSpec place(const Scenario& s) {
    if (s.grid)
      return {.cell = {{pick(10'000), pick(10'000)}}, .layer = coin() ? std::optional(pick(10'000)) : std::nullopt};
    const bool automatic = !s.frame.local && !s.frame.origin && s.frame.crs == "auto";
    if (s.frame.local || (!automatic && coin())) return {.position_m = position<3>()};
    PlaceSpec p{.lat_deg = number(-90, 90), .lon_deg = number(-180, 180)};
    (s.terrain && coin() ? p.agl_m : p.amsl_m) = number(-100, 9000);
    return p;
  }
  NavigationSpec navigation(const Scenario& s) {
    NavigationSpec n{.alpha = {number(0, 9), positive()}, .beta = {positive(), 0}, .theta = positive()};
    if (coin()) {
      n.points_file = "folder/" + word();
    } else {
      for (int i = pick(5); i >= 0; --i) n.points.push_back(point(s));
    }
    n.drift_vertical_per_m = number(0, 1);
    n.success = number(0, 1);
    n.residual = positive();
    maybe(n.turn_radius_m, 1, 300);
    if (n.turn_radius_m) n.turn_model = static_cast<TurnModel>(pick(3));
    return n;
  }
  CorrectionPointSpec point(const Scenario& s) {
    CorrectionPointSpec p{.kind = static_cast<PointKind>(pick(4)), .may_fail = coin()};
    if (coin()) p.id = pick(1000);
    if (s.frame.local || coin()) {
      p.position_m = position<3>();
    } else {
      p.lat_deg = number(-90, 90);
      p.lon_deg = number(-180, 180);
      p.amsl_m = number(-9, 99);
    }
    return p;
  }
  VehicleSpec vehicle() {
    VehicleSpec v;
    maybe(v.speed_mps, 1, 300);
    maybe(v.turn_radius_m, 1, 3000);
    maybe(v.climb_deg, 1, 89);
    maybe(v.descent_deg, 1, 89);
    maybe(v.range_m, 1, 1e8);
    if (coin()) {
      v.step_m = positive();
      for (auto* angles : {&v.roll_deg, &v.pitch_deg, &v.yaw_deg})
        for (int i = pick(5); i >= 0; --i) angles->push_back(number(-90, 90));
    }
    return v;
  }
  ThreatSpec threat(const Scenario& s) {
    ThreatSpec t{.name = word() + std::to_string(s.threats.size()), .radius_m = positive(), .level = positive()};
    t.core_m = coin() ? 0 : t.radius_m * number(0, 1);
    if (coin()) {
      t.cylinder = CylinderSpec{.floor_m = number(-9, 9), .top_m = number(10, 99)};
      if (s.frame.local || s.grid || coin()) {
        t.cylinder->center_m = position<2>();
      } else {
        t.cylinder->lat_deg = number(-90, 90);
        t.cylinder->lon_deg = number(-180, 180);
      }
      return t;
    }
    const PlaceSpec p = place_of_threat(s);
    t.center_m = p.position_m;
    t.lat_deg = p.lat_deg;
    t.lon_deg = p.lon_deg;
    t.amsl_m = p.amsl_m;
    t.agl_m = p.agl_m;
    return t;
  }
  PlaceSpec place_of_threat(const Scenario& s) {
    if (s.grid) return {.position_m = position<3>()};
    return place(s);
  }
  void objective(ObjectiveSpec& o) {
    if (coin()) {
      o = {.length = positive(), .threat = positive(), .climb = positive()};
    } else {
      o = {.model = CostModel::konatowski2019, .threat = number(0, 1)};
      o.fuel = 1 - o.threat;
    }
  }

  std::mt19937 random_;
};

TEST(ScenarioWrite, RandomScenariosReadBackEqual) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const Scenario scenario = Generator(seed).scenario();
    const std::string text = to_yaml(scenario);
    try {
      ASSERT_EQ(parse_scenario(text, "s.yaml"), scenario) << "seed " << seed << "\n" << text;
    } catch (const InputError& error) {
      FAIL() << "seed " << seed << "\n" << error.what() << "\n" << text;
    }
  }
}

TEST(ScenarioWrite, FullScenarioReadsBackEqual) {
  const Scenario scenario = parse_scenario(test::kFullScenario, "s.yaml");
  EXPECT_EQ(parse_scenario(to_yaml(scenario), "s.yaml"), scenario);
}

TEST(ScenarioWrite, NumbersHaveTheFewestDigits) {
  Scenario scenario = parse_scenario(test::kSmallScenario, "s.yaml");
  scenario.goal.tolerance_m = 0.1;
  EXPECT_NE(to_yaml(scenario).find("tolerance_m: 0.1\n"), std::string::npos);
}

}  // namespace
}  // namespace alate
