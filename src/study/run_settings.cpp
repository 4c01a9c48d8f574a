#include "study/run_settings.hpp"

#include <fmt/core.h>

#include "alate/core/version.hpp"
#include "study/machine.hpp"

namespace alate {

namespace {

/// "attitude-aco, preset acs: ants=50 ...", with the iterations if they were set.
std::string method_text(const StudyMethod& method, const ChosenPlanner& planner) {
  std::string text = fmt::format("{}, preset {}:", planner.name, planner.preset);
  for (const auto& [name, value] : planner.parameters.all()) text += fmt::format(" {}={}", name, to_text(value));
  if (method.iterations) text += fmt::format(", {} iterations", *method.iterations);
  return text;
}

}  // namespace

RunSettings run_settings(std::uint64_t seeds, int threads) {
  const Machine machine = this_machine();
  return {{"alate", version()},
          {"seeds", fmt::format("1 to {}", seeds)},
          {"runs_without_chance", std::int64_t{1}},
          {"threads", std::int64_t{threads}},
          {"threads_per_run", std::int64_t{1}},
          {"processor", machine.processor},
          {"cores", static_cast<std::int64_t>(machine.cores)},
          {"compiler", machine.compiler}};
}

void append_methods(const Experiment& experiment, RunSettings& settings) {
  for (std::size_t m = 0; m < experiment.methods.size(); ++m)
    settings.emplace_back("method " + experiment.methods[m].name,
                          method_text(experiment.methods[m], experiment.at(0, m).planner));
}

}  // namespace alate
