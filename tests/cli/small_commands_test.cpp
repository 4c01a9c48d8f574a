// planners, init and schema.
#include "program.hpp"

namespace alate::test {

namespace {

TEST(Planners, AreListedWithTheirParameters) {
  const Finished done = alate({"planners", "--json"});
  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.err, "");
  const Json all = Json::parse(done.out);
  std::vector<std::string> names;
  for (const Json& each : all) {
    names.push_back(each.at("name"));
    EXPECT_FALSE(each.at("presets").empty());
    EXPECT_TRUE(each.at("can").contains("anytime"));
    for (const Json& parameter : each.at("parameters"))
      for (const char* key : {"name", "unit", "default", "range", "help", "source"})
        EXPECT_TRUE(parameter.contains(key)) << each.at("name") << ' ' << key;
  }
  for (const char* name : {"greedy", "beam"}) EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
}

TEST(Planners, OneByName) {
  const Finished text = alate({"planners", "beam"});
  EXPECT_EQ(text.code, 0);
  expect_contains(text.out, {"beam"});
  EXPECT_EQ(text.out.find("greedy:"), std::string::npos);
  EXPECT_EQ(Json::parse(alate({"planners", "beam", "--json"}).out).size(), 1U);
}

TEST(Planners, UnknownNameIsAFault) {
  const Finished done = alate({"planners", "baem"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"baem", "did you mean beam?"});
}

TEST(Init, WritesAScenarioThatCanBePlanned) {
  const TempFolder folder;
  Command init = alate_command({"init"});
  init.folder = folder.path();
  EXPECT_EQ(run(init).code, 0);
  const std::string file = (folder / "scenario.yaml").string();
  expect_contains(read_file(file), {"#", "start:", "goal:"});
  const Finished planned = alate({"plan", file});
  EXPECT_EQ(planned.code, 0) << planned.out << planned.err;
}

TEST(Init, OverwritesNothing) {
  const TempFolder folder;
  write_file(folder / "mine.yaml", "mine");
  const Finished done = alate({"init", (folder / "mine.yaml").string()});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"mine.yaml", "left alone"});
  EXPECT_EQ(read_file(folder / "mine.yaml"), "mine");
}

TEST(Init, FolderThatIsNotThere) {
  const TempFolder folder;
  const Finished done = alate({"init", (folder / "none/mine.yaml").string()});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"none/mine.yaml"});
  EXPECT_TRUE(folder.empty());
}

TEST(Schema, IsJsonOrAManual) {
  const Finished schema = alate({"schema"});
  EXPECT_EQ(schema.code, 0);
  EXPECT_TRUE(Json::parse(schema.out).contains("$schema"));
  const Finished manual = alate({"schema", "--markdown"});
  EXPECT_EQ(manual.code, 0);
  expect_contains(manual.out, {"clearance_m", "heading_deg"});
}

}  // namespace

}  // namespace alate::test
