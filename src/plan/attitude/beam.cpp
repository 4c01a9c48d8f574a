#include "search/beam.hpp"

#include "plan/attitude/attitude_plan.hpp"
#include "plan/attitude/attitude_planners.hpp"
#include "search/greedy.hpp"

namespace alate {

namespace {

struct BeamPlanner {
  BeamOptions options;
  std::size_t step_limit = 0;

  /// The greedy walk comes first, as narrow passes may find nothing in a narrow band; it must not eat up the time.
  static GreedyOptions first_walk() { return {.max_step_backs = 500}; }

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_on_attitudes(problem, run, {.step_limit = step_limit}, [&](const AttitudeSpace& space) {
      return Beam(space, options).run(run, Greedy(space, first_walk()).run(run));
    });
  }
};

std::vector<Parameter> parameters() {
  return {
      {.name = "width",
       .default_value = std::int64_t{32},
       .min = 1,
       .max = 8192,
       .help = "States kept a step in the first pass; every pass doubles it. An iteration is a pass.",
       .source = "alate"},
      {.name = "max_width",
       .default_value = std::int64_t{8192},
       .min = 1,
       .max = 65536,
       .help = "Widest pass; never more than fits 4 million candidates (100 MB).",
       .source = "alate"},
      step_limit_parameter(),
  };
}

}  // namespace

PlannerEntry beam_entry() {
  return {
      .name = "beam",
      .help =
          "A greedy walk, then the best few states of every step in wider and wider passes: the longer, the better.",
      .can = {.anytime = true, .deterministic = true, .terrain = true, .threats = true, .space = "attitude lattice"},
      .presets = {{.name = "default", .help = "As the parameters say."}},
      .parameters = ParamTable(parameters()),
      .refuses = attitude_refusal,
      .make = [](const ParamValues& values) {
        return Planner(BeamPlanner{.options = {.width = static_cast<std::size_t>(values.integer("width")),
                                               .max_width = static_cast<std::size_t>(values.integer("max_width"))},
                                   .step_limit = static_cast<std::size_t>(values.integer("step_limit"))});
      }};
}

}  // namespace alate
