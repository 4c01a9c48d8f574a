#include "search/greedy.hpp"

#include "plan/attitude/attitude_plan.hpp"
#include "plan/attitude/attitude_planners.hpp"

namespace alate {

namespace {

struct GreedyPlanner {
  GreedyOptions options;
  std::size_t step_limit = 0;

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_on_attitudes(problem, run, {.step_limit = step_limit}, [&](const AttitudeSpace& space) {
      SearchResult result;
      if (run.start_iteration(1)) result = Greedy(space, options).run(run);
      return result;
    });
  }
};

std::vector<Parameter> parameters() {
  return {
      {.name = "score",
       .default_value = std::string("J+h"),
       .choices = {"J", "J+h"},
       .help = "What the next leg is chosen by: its cost J alone, or J and the estimated cost from there to the goal. "
               "J alone knows of the goal only in the konatowski2019 model.",
       .source = "Konatowski, Pawlowski 2019, eq. (33); h: alate"},
      step_limit_parameter(),
      {.name = "step_backs",
       .default_value = std::int64_t{20000},
       .min = 0,
       .max = 1e9,
       .help = "Where nothing can be flown, the walk steps back and takes the next best, at most this often; 0: a pure "
               "walk.",
       .source = "alate"},
  };
}

}  // namespace

PlannerEntry greedy_entry() {
  return {.name = "greedy",
          .help = "Walks on with the best next leg and steps back where it is stuck: quick, seldom the cheapest.",
          .can = {.deterministic = true, .terrain = true, .threats = true, .space = "attitude lattice"},
          .presets = {{.name = "default", .help = "As the parameters say."}},
          .parameters = ParamTable(parameters()),
          .refuses = attitude_refusal,
          .make = [](const ParamValues& values) {
            return Planner(
                GreedyPlanner{.options = {.use_guide = values.text("score") == "J+h",
                                          .max_step_backs = static_cast<std::size_t>(values.integer("step_backs"))},
                              .step_limit = static_cast<std::size_t>(values.integer("step_limit"))});
          }};
}

}  // namespace alate
