#include "search/sparse_astar.hpp"

#include "plan/correction/correction_heuristic.hpp"
#include "plan/correction/correction_planners.hpp"

namespace alate {

namespace {

constexpr const char* kPaper = "Zhou et al. 2020, improved sparse A*";

struct SparseAstarPlanner {
  SparseAstarOptions options;

  Plan plan(const Problem& problem, RunContext& run) const {
    constexpr double kWhole = 0;
    return plan_on_corrections(problem, run, kWhole, [&](const CorrectionTask& task) {
      SparseAstarResult result = sparse_astar(task.graph, options, run);
      return CorrectionFound{.found = result.found,
                             .points = std::move(result.points),
                             .exhausted = result.exhausted,
                             .bound_m = result.bound_m,
                             .candidates = result.candidates,
                             .expansions = result.expansions};
    });
  }
};

std::string refusal(const Problem& problem) {
  if (std::string why = heuristic_refusal(problem); !why.empty()) return why;
  return problem.prefer == Preference::corrections ? "looks for short routes, and cannot prefer fewer corrections" : "";
}

SparseAstarOptions options_of(const ParamValues& values) {
  SparseAstarOptions options{.keep_errors = values.text("labels") == "node-and-error"};
  const std::string& weights = values.text("weights");
  if (weights == "2") {
    options.q2 = 0.5;
    options.q3 = 0.2;
  } else if (weights == "own") {
    options.q1 = values.number("q1");
    options.q2 = values.number("q2");
    options.q3 = values.number("q3");
  }
  return options;
}

Parameter weight(const char* name, double value, const char* help, const char* source = kPaper) {
  return {.name = name, .default_value = value, .min = 0, .max = 1e6, .help = help, .source = source};
}

std::vector<Parameter> parameters() {
  return {
      {.name = "labels",
       .default_value = std::string("node-and-error"),
       .choices = {"node-and-error", "node"},
       .help = "What the lists keep: the ways to a point that differ in length and error, or one way a point, as "
               "published.",
       .source = "node: Zhou et al. 2020; node-and-error: alate"},
      {.name = "weights",
       .default_value = std::string("1"),
       .choices = {"1", "2", "own"},
       .help =
           "q1, q2, q3 of f = q1 R + q2 S + q3 h: 0.3, 0.2, 0.5 or 0.3, 0.5, 0.2 as published, or those given here.",
       .source = kPaper},
      weight("q1", 0.5, "own: of R, the length flown."),
      weight("q2", 0, "own: of S, length times drift."),
      weight("q3", 0.5, "own: of h, the straight line left; at most q1: the route is the shortest."),
  };
}

}  // namespace

PlannerEntry sparse_astar_entry() {
  return {
      .name = "sparse-astar",
      .help = "A* over correction points: as published in 2020, and with the error kept.",
      .can = {.deterministic = true, .terrain = true, .space = "correction points"},
      .presets = {{.name = "corrected",
                   .help = "The published weights, with a label for each way that differs in error."},
                  {.name = "zhou2020",
                   .help = "As published: one way a point, whatever the error.",
                   .values = {{"labels", std::string("node")}}},
                  {.name = "zhou2020-plain",
                   .help = "Plain A*, its baseline; the weights are not printed, and q2 = 0 with q1 = q3 is our guess.",
                   .values = {{"labels", std::string("node")}, {"weights", std::string("own")}}}},
      .parameters = ParamTable(parameters()),
      .refuses = refusal,
      .make = [](const ParamValues& values) { return Planner(SparseAstarPlanner{options_of(values)}); }};
}

}  // namespace alate
