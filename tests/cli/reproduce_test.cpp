// alate reproduce.
#include <csignal>
#include <thread>

#include "out/xml_balance.hpp"
#include "program.hpp"
#include "support/shared_data.hpp"

namespace alate::test {

namespace {

/// Enough to have every part, too little to say anything.
std::vector<std::string> brief(std::initializer_list<std::string> more) {
  std::vector<std::string> words{"reproduce", "konatowski2019", "--seeds", "1", "--iterations", "3"};
  words.insert(words.end(), more);
  return words;
}

TEST(Reproduce, ShowsAndWrites) {
  const TempFolder folder;
  const std::string out = (folder / "new/out").string();
  const Finished done = alate(brief({"--out", out}));
  EXPECT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"Claims", "109.97", "cannot_be_told", "reproduce.html"});
  expect_contains(read_file(folder / "new/out/reproduce.html"), {"<!DOCTYPE html>", "Layout F"});
  EXPECT_EQ(Json::parse(read_file(folder / "new/out/reproduce.json")).at("paper"), "konatowski2019");
}

TEST(Reproduce, JsonIsAllThatStandardOutputHolds) {
  const Finished done = alate(brief({"--json"}));
  EXPECT_EQ(done.code, 0) << "whatever the verdicts say";
  EXPECT_EQ(done.err, "");
  const Json json = Json::parse(done.out);
  for (const char* key : {"paper", "claims", "cells", "settings"}) EXPECT_TRUE(json.contains(key)) << key;
}

TEST(Reproduce, TellsAllFaultsAtOnce) {
  const TempFolder folder;
  write_file(folder / "file", "");
  const Finished done = alate({"reproduce", "konatovski2019", "--seeds", "0", "--threads", "none", "--iterations", "-1",
                               "--out", (folder / "file").string(), "--sed"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"did you mean konatowski2019?", "--seeds", "1 to 1000", "--threads", "--iterations",
                             "is not a folder", "did you mean --seeds?"});
}

TEST(Reproduce, NamesTheDataThatAreMissing) {
  const TempFolder folder;
  const Finished done = alate({"reproduce", "zhou2020", "--data", folder.path().string()});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {(folder / "set1.csv").string(), (folder / "set2.csv").string(), "--data"});
}

TEST(Reproduce, JudgesPublishedRoutes) {
  ALATE_NEEDS_SHARED_DATA("correction-points");
  const std::string data = shared_data("correction-points").string();
  const Finished done = alate({"reproduce", "zhou2020", "--data", data, "--seeds", "1", "--iterations", "2", "--json"});
  EXPECT_EQ(done.code, 0) << done.err;
  const Json claims = Json::parse(done.out).at("claims");
  const auto verdict = [&](std::string_view id) {
    for (const Json& claim : claims)
      if (claim.at("id") == id) return claim.at("verdict").get<std::string>();
    return std::string("not there");
  };
  EXPECT_EQ(verdict("table-2"), "impossible");
  EXPECT_EQ(verdict("prize-1"), "holds");
  EXPECT_EQ(verdict("niu-1"), "cannot_be_told");
}

TEST(Reproduce, TestsClaimsOnDrawnMaps) {
  const Finished done = alate({"reproduce", "yin2021", "--seeds", "1", "--iterations", "1", "--json"});
  EXPECT_EQ(done.code, 0) << done.err;
  const Json json = Json::parse(done.out);
  EXPECT_EQ(json.at("claims").size(), 13U);
  for (const Json& claim : json.at("claims")) EXPECT_FALSE(claim.at("why").get<std::string>().empty());
  EXPECT_TRUE(json.at("settings").contains("maps_30x30"));
}

TEST(Reproduce, TestsClaimsOverTerrain) {
  const TempFolder folder;
  const Finished done =
      alate({"reproduce", "mai2023", "--seeds", "1", "--iterations", "12", "--out", folder.path().string()});
  EXPECT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"no percentage of improvement is known", "superior to ACO on"});
  const std::string page = read_file(folder / "reproduce.html");
  EXPECT_EQ(xml_fault(page), "");
  expect_contains(page, {"Simple scene", "A third scene, ours", "Their heights", "Every reading", "q0 jumps"});
  const Json json = Json::parse(read_file(folder / "reproduce.json"));
  EXPECT_EQ(json.at("claims").size(), 9U);
  EXPECT_EQ(json.at("claims").back().at("verdict"), "cannot_be_told") << "the complex terrain is not known";
  for (const Json& claim : json.at("claims")) EXPECT_FALSE(claim.at("why").get<std::string>().empty());
  for (const Json& cell : json.at("details")) {
    if (cell.at("best").is_null() || cell.at("method") == "improved") continue;
    EXPECT_GE(cell.at("best").get<double>(), cell.at("lower_bound").get<double>() - 1e-4) << cell.dump();
  }
}

TEST(Reproduce, NeedsAPaper) {
  const Finished done = alate({"reproduce", "--json"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"PAPER"});
  EXPECT_TRUE(Json::parse(done.out).contains("errors"));
}

TEST(Reproduce, StopsWhenInterrupted) {
  const TempFolder folder;
  Process process(alate_command({"reproduce", "konatowski2019", "--seeds", "1000", "--out", folder.path().string()}));
  while (process.running() && !process.blocks(SIGINT)) std::this_thread::yield();
  process.send(SIGINT);
  const Finished done = process.wait(60);
  EXPECT_EQ(done.code, 130);
  EXPECT_TRUE(folder.empty());
}

}  // namespace

}  // namespace alate::test
