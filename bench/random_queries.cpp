// Thousands of flights between random places in the worlds of examples/worlds: is any route wrong, how many are found,
// and how soon.
//
//     bench_random_queries --queries 10000 --seconds 0.3 --again 5
//
// The queries are a function of the seed. Every query that was not solved is asked once more with `--again` seconds,
// which tells those that can be solved from those that perhaps cannot. Times are of the planner alone, one thread a
// query. A wrong answer is printed with the command that asks it again, and makes the program return 1.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "../tests/support/random_queries.hpp"
#include "../tests/support/worlds.hpp"

namespace {

using namespace alate;

struct Options {
  std::size_t queries = 1000;
  std::uint64_t seed = 1;
  double seconds = 0.3;
  std::optional<std::uint64_t> iterations;
  double again_s = 0;
  int threads = 1;
  std::string only;
  bool list = false;
};

struct Query {
  std::size_t world = 0;
  std::optional<Mission> mission;
  test::Answer answer;
  std::optional<double> first_s;
  bool solved_later = false;
};

struct Ground {
  std::string name;
  World world;
};

std::vector<Ground> grounds(const std::string& only) {
  std::vector<Ground> all;
  for (const test::FlightWorld& world : test::flight_worlds())
    for (const char* band : test::kBandNames) {
      std::string name = world.name + "-" + band;
      if (!name.starts_with(only)) continue;
      if (world.has_ground())
        all.push_back({std::move(name), World(load_site(test::world_scenario(world, band)))});
      else
        fmt::print(stderr, "SKIPPED {}: needs {}\n", name, test::shared_data(world.dem).string());
    }
  return all;
}

void ask(const Ground& ground, const Options& options, Query& query) {
  const auto ask_for = [&](std::optional<std::uint64_t> iterations, double seconds) {
    return test::fly_query(ground.world.site(), *query.mission, {.iterations = iterations, .time_limit_s = seconds});
  };
  query.answer = ask_for(1, options.seconds);
  if (!query.answer.fault.empty()) return;
  if (query.answer.solved()) query.first_s = query.answer.planner_s;
  query.answer = ask_for(options.iterations, options.seconds);
  if (query.answer.solved() || !query.answer.fault.empty() || options.again_s <= 0) return;
  const test::Answer again = ask_for({}, options.again_s);
  query.solved_later = again.solved();
  query.answer.fault = again.fault;
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

struct Row {
  std::size_t asked = 0, found = 0, later = 0, proven = 0, gave_up = 0, wrong = 0;
  std::vector<double> first_ms;

  void add(const Query& query) {
    ++asked;
    found += query.answer.solved() ? 1U : 0U;
    later += query.solved_later ? 1U : 0U;
    proven += query.answer.outcome == Outcome::infeasible_proven ? 1U : 0U;
    gave_up += !query.answer.solved() && query.answer.stop == Stop::finished ? 1U : 0U;
    wrong += query.answer.fault.empty() ? 0U : 1U;
    if (query.first_s) first_ms.push_back(1e3 * *query.first_s);
  }
  void print(const std::string& name) const {
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.0f} | {:.0f} |\n", name, asked, found, later, gave_up, proven,
               wrong, quantile(first_ms, 0.5), quantile(first_ms, 0.99));
  }
};

int print_table(const std::vector<Ground>& worlds, const std::vector<Query>& queries, const Options& options) {
  std::vector<Row> rows(worlds.size());
  Row all;
  for (const Query& query : queries) {
    if (!query.mission) continue;
    rows[query.world].add(query);
    all.add(query);
    const bool unsolved = !query.answer.solved();
    if (query.answer.fault.empty() && !(options.list && unsolved)) continue;
    const Ground& ground = worlds[query.world];
    fmt::print(stderr, "{}: {}\n  {}\n", ground.name,
               !query.answer.fault.empty() ? query.answer.fault
               : query.solved_later        ? "solved later"
                                           : "not solved",
               test::command_for(ground.world.site(), *query.mission, "examples/worlds/" + ground.name + ".yaml"));
  }
  fmt::print(
      "| world | asked | solved | solved in {} s more | gave up | proven infeasible | wrong | first route p50 ms | p99 "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|\n",
      options.again_s);
  for (std::size_t i = 0; i < worlds.size(); ++i) rows[i].print(worlds[i].name);
  all.print("all");
  return all.wrong == 0 ? 0 : 1;
}

int run(const Options& options) {
  const std::vector<Ground> worlds = grounds(options.only);
  if (worlds.empty()) return 2;
  std::vector<Query> queries(options.queries);
  Executor executor(options.threads);
  executor.for_ranges(queries.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      queries[i].world = i % worlds.size();
      const Ground& ground = worlds[queries[i].world];
      queries[i].mission = test::draw_mission(ground.world, Stream(options.seed, queries[i].world, i));
      if (queries[i].mission) ask(ground, options, queries[i]);
    }
  });
  return print_table(worlds, queries, options);
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  CLI::App app("Flights between random places");
  app.add_option("--queries", options.queries, "in all worlds together");
  app.add_option("--seed", options.seed);
  app.add_option("--seconds", options.seconds, "for each query");
  app.add_option("--iterations", options.iterations, "at most, for each query");
  app.add_option("--again", options.again_s, "seconds for those not solved; 0: none");
  app.add_option("--threads", options.threads, "queries at a time")->check(CLI::Range(1, 1024));
  app.add_option("--world", options.only, "begin of the names of worlds, such as davos");
  app.add_flag("--list", options.list, "print what was not solved, too");
  CLI11_PARSE(app, argc, argv);
  return run(options);
} catch (const std::exception& fault) {
  std::fputs(fault.what(), stderr);
  return 1;
}
