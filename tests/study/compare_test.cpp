// Comparisons: what counts when, and peers that misbehave.
#include "alate/study/compare.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "alate/data/scenario_file.hpp"
#include "study/compare/figures.hpp"
#include "study/compare/peers.hpp"
#include "support/process.hpp"

namespace alate {

namespace {

using test::TempFolder;
using test::write_file;

constexpr const char* kOpen =
    "frame: {local: true}\n"
    "start: {position_m: [0, 0, 100], heading_deg: 90}\n"
    "goal: {position_m: [2000, 0, 100], tolerance_m: 50}\n"
    "vehicle: {turn_radius_m: 80}\n";

/// The straight way there, and one that ends too early.
constexpr const char* kGood =
    R"({"schema":1,"time_s":0.01,"route":[{"x_m":0,"y_m":0,"z_m":100,"leg":"start"},{"x_m":2000,"y_m":0,"z_m":100}]})";
constexpr const char* kShort =
    R"({"schema":1,"time_s":0.001,"route":[{"x_m":0,"y_m":0,"z_m":100,"leg":"start"},{"x_m":1000,"y_m":0,"z_m":100}]})";

class Peers : public testing::Test {
 protected:
  /// A program that names one peer, and runs it as told by lines of sh.
  std::string program(const std::string& lines) const {
    const auto file = folder_ / "peers.sh";
    write_file(file,
               "#!/bin/sh\ncat > /dev/null\nif [ \"$1\" = list ]; then\n  echo '{\"peers\": [{\"name\": \"odd\"}]}'\n"
               "  exit 0\nfi\n" +
                   lines);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file.string();
  }

  PeerRun run(const std::string& lines, double seconds = 0.1) const {
    return run_peer({.program = program(lines), .name = "odd", .seconds = seconds, .seed = 1}, world_.site(), {});
  }

  /// A sleep first makes sure that no route is older than its program.
  static std::string says(const std::string& line) { return "sleep 0.05\necho '" + line + "'\n"; }

  TempFolder folder_;
  World world_{load_site(parse_scenario(kOpen, "open.yaml"))};
  const std::string ready_ = "echo '{\"ready\": true}'\n";
  const std::string done_ = "echo '{\"done\": true}'\n";
};

TEST_F(Peers, HandOverRoutesWithTheirTimes) {
  const PeerRun run = this->run(ready_ + says(kShort) + says(kGood) + done_);
  EXPECT_EQ(run.end.ending, PeerEnding::finished) << run.end.note;
  ASSERT_EQ(run.routes.size(), 2U);
  EXPECT_EQ(run.routes[1].time_s, 0.01);
  EXPECT_EQ(run.routes[1].route.states.back().position, Vec3(2000, 0, 100));
}

TEST_F(Peers, KeepWhatTheyHandedOverBeforeTheyAbort) {
  const PeerRun run = this->run(ready_ + says(kGood) + "echo 'Assertion failed' >&2\nkill -ABRT $$\n");
  EXPECT_EQ(run.end.ending, PeerEnding::aborted);
  EXPECT_NE(run.end.note.find("signal 6"), std::string::npos) << run.end.note;
  EXPECT_NE(run.end.note.find("Assertion failed"), std::string::npos) << run.end.note;
  EXPECT_EQ(run.routes.size(), 1U);
}

TEST_F(Peers, AreKilledWhenTheyHangWithAllTheirChildren) {
  const std::string sign = (folder_ / "alive").string();
  const PeerRun run = this->run(ready_ + fmt::format("(sleep 4; touch {0}) &\nsleep 60\n", sign));
  EXPECT_EQ(run.end.ending, PeerEnding::hung);
  std::system("sleep 3");
  EXPECT_FALSE(std::filesystem::exists(sign));
}

TEST_F(Peers, AreKilledForRubbish) {
  for (const std::string& rubbish :
       {std::string("hello"), std::string("[1]"), std::string("{}"),
        std::string(R"({"schema":1,"time_s":-1,"route":[]})"), std::string(R"({"schema":1,"time_s":1e9,"route":[]})"),
        std::string(R"({"schema":1,"time_s":0,"route":"no"})"),
        std::string(R"({"schema":1,"time_s":0,"route":[{"x_m":"east"}]})")}) {
    const PeerRun run = this->run(ready_ + says(rubbish) + "sleep 60\n");
    EXPECT_EQ(run.end.ending, PeerEnding::rubbish) << rubbish;
    EXPECT_TRUE(run.routes.empty()) << rubbish;
  }
  EXPECT_EQ(run("head -c 100000 /dev/urandom\n").end.ending, PeerEnding::rubbish);
  EXPECT_EQ(run(ready_).end.ending, PeerEnding::rubbish) << "it did not say that it was done";
}

TEST_F(Peers, TellExitCodesAndMissingPrograms) {
  EXPECT_EQ(run(ready_ + "exit 7\n").end.ending, PeerEnding::failed);
  EXPECT_NE(run(ready_ + "exit 7\n").end.note.find("exit code 7"), std::string::npos);
  const PeerList list = list_peers((folder_ / "nowhere").string(), world_.site(), {});
  EXPECT_EQ(list.end.ending, PeerEnding::failed);
  EXPECT_TRUE(list.planners.empty());
}

TEST_F(Peers, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  const PeerTask task{.program = program(ready_ + "sleep 60\n"), .name = "odd", .seconds = 60, .seed = 1};
  EXPECT_EQ(run_peer(task, world_.site(), stop.get_token()).end.ending, PeerEnding::stopped);
}

TEST_F(Peers, StandBesideOursAndAreJudgedAlike) {
  const Comparison comparison = compare_planners(
      world_,
      {.seconds = 0.2, .seeds = 2, .only = {"odd"}, .peers = program(ready_ + says(kShort) + says(kGood) + done_)});
  ASSERT_EQ(comparison.contenders.size(), 1U);
  EXPECT_TRUE(comparison.contenders[0].peer);
  ASSERT_EQ(comparison.runs.size(), 2U);
  const CompareRun& run = comparison.runs[0];
  ASSERT_EQ(run.marks.size(), comparison.times_s.size());
  EXPECT_EQ(run.marks.front().standing, Standing::refused) << "the short route alone is there after 2 ms";
  EXPECT_EQ(run.marks.front().broken, "arrival");
  EXPECT_EQ(run.marks.back().standing, Standing::passed);
  EXPECT_DOUBLE_EQ(run.marks.back().metrics.length_m, 2000);
  EXPECT_EQ(run.refused, 1U);
  EXPECT_EQ(run.routes, 2U);
}

TEST_F(Peers, ThatCannotBeAskedAreToldOf) {
  const auto file = folder_ / "broken.sh";
  write_file(file, "#!/bin/sh\nkill -SEGV $$\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  const Comparison comparison =
      compare_planners(world_, {.seconds = 0.02, .seeds = 1, .only = {"interval-astar"}, .peers = file.string()});
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_NE(comparison.notes[0].find("aborted, signal 11"), std::string::npos) << comparison.notes[0];
  EXPECT_EQ(comparison.runs.size(), 1U);
}

/// Two contenders at two times, costs by seed; nothing: no route.
class Figures : public testing::Test {
 protected:
  Figures() {
    comparison_.times_s = {0.1, 1};
    comparison_.seeds = 3;
    comparison_.contenders = {{.name = "ours"}, {.name = "theirs", .peer = true}};
    add(0, {110, 100});
    add(1, {{}, 90});
    add(0, {120, 102});
    add(1, {{}, 104});
    add(0, {{}, 101});
    add(1, {130, 106});
  }

  void add(std::size_t contender, const std::vector<std::optional<double>>& costs) {
    CompareRun run{.contender = contender, .seed = comparison_.runs.size() / 2 + 1};
    for (const auto& cost : costs)
      run.marks.push_back(
          {.standing = cost ? Standing::passed : Standing::none, .metrics = {.cost = cost.value_or(0)}});
    comparison_.runs.push_back(std::move(run));
  }

  Comparison comparison_{.world = World(load_site(parse_scenario(kOpen, "open.yaml")))};
};

TEST_F(Figures, CountRunsWithoutARouteAsCostliest) {
  const CompareFigures ours = figures_of(comparison_, 0, 0);
  EXPECT_EQ(ours.median, 120);
  EXPECT_EQ(ours.none, 1U);
  EXPECT_DOUBLE_EQ(ours.cost->mean, 115);
  EXPECT_EQ(ours.typical, &comparison_.runs[2]);
  EXPECT_FALSE(figures_of(comparison_, 1, 0).solves());
  EXPECT_EQ(best_cost(comparison_), 90);
}

TEST_F(Figures, RankByMedians) {
  const auto early = ranking(comparison_, 0);
  EXPECT_EQ(early[0].contender, 0U);
  const auto late = ranking(comparison_, 1);
  EXPECT_EQ(late[0].contender, 0U);
  EXPECT_EQ(late[0].median, 101);
  EXPECT_EQ(late[1].median, 104);
}

TEST_F(Figures, SayWhoIsBestAndByHowMuch) {
  const auto said = findings(comparison_);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_NE(said[0].find("From 0.1 s to 1 s ours is best: median cost 101.0"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("theirs comes next, 2.97 % above"), std::string::npos) << said[0];
  EXPECT_NE(said[1].find("costs 0.9712 times"), std::string::npos) << said[1];
}

TEST_F(Figures, SayWhoLeadsWhenThatChanges) {
  for (CompareRun& run : comparison_.runs)
    if (run.contender == 0) run.marks[1].standing = Standing::refused, run.marks[1].broken = "turn";
  comparison_.runs[1].ending = "aborted";
  comparison_.runs[1].note = "signal 6";
  const auto said = findings(comparison_);
  ASSERT_EQ(said.size(), 4U);
  EXPECT_NE(said[1].find("With 1 s theirs is best"), std::string::npos) << said[1];
  EXPECT_NE(said[2].find("aborted 1 times (signal 6)"), std::string::npos) << said[2];
  EXPECT_NE(said[3].find("ours failed in 3 of 3 runs: in 3 the check refuses the route (turn)"), std::string::npos)
      << said[3];
}

TEST_F(Figures, AreWrittenDown) {
  const std::string rows = compare_csv(comparison_);
  EXPECT_EQ(std::ranges::count(rows, '\n'), 1 + 6 * 2);
  EXPECT_NE(rows.find("\ntheirs,,true,1,0.1,none,,,,,0,,finished\n"), std::string::npos) << rows;
  const std::string page = compare_html(comparison_);
  EXPECT_NE(page.find("Cost against time"), std::string::npos);
  EXPECT_NE(page.find("theirs"), std::string::npos);
}

TEST(Grace, IsATwentiethOrAFewMilliseconds) {
  EXPECT_DOUBLE_EQ(with_grace(10), 10.5);
  EXPECT_DOUBLE_EQ(with_grace(0.01), 0.015);
}

TEST(CostWords, HaveFiveDigitsOrMore) {
  EXPECT_EQ(cost_words(13.31371), "13.314");
  EXPECT_EQ(cost_words(6382.48), "6382.5");
  EXPECT_EQ(cost_words(74995.62), "74995.6");
  EXPECT_EQ(cost_words(std::numeric_limits<double>::infinity()), "–");
}

}  // namespace

}  // namespace alate
