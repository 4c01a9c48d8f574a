#include "study/zhou2020/study.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "alate/core/fault.hpp"

namespace alate::zhou2020 {

namespace {

struct Asked {
  const char* name;
  const char* planner;
  const char* preset;
  const char* weights;  ///< Of sparse A*; empty: the default.
  const char* help;
};

constexpr std::array<Asked, 11> kMethods{{
    {kExact, "label-setting", "", "", "exact: nothing is shorter"},
    {kCorrectedAstar, "sparse-astar", "corrected", "", "a label for every node and error"},
    {kAstar1, "sparse-astar", "zhou2020", "1", "the paper's: one label a node, length counted twice"},
    {kAstar2, "sparse-astar", "zhou2020", "2", "the same with weights 2"},
    {kPlainAstar1, "sparse-astar", "zhou2020-plain", "1", "the paper's baseline; its weights are our guess"},
    {kPlainAstar2, "sparse-astar", "zhou2020-plain", "2", "the same with weights 2"},
    {kPaperGa, "correction-ga", "zhou2020", "", "the paper's"},
    {kPlainGa, "correction-ga", "zhou2020-plain", "", "the paper's baseline"},
    {kImproved, "correction-ga", "improved", "", "alate's own: strings of any length, repaired and searched locally"},
    {kAntSystem, "correction-aco", "as", "", "ants on the same points, Ant System"},
    {kAnts, "correction-aco", "mmas", "", "ants on the same points, MAX-MIN"},
}};

StudyMethod method(const Asked& asked, const std::optional<std::uint64_t>& iterations) {
  StudyMethod method{.name = asked.name,
                     .help = asked.help,
                     .request = {.name = asked.planner, .preset = asked.preset, .settings = {}},
                     .iterations = {}};
  if (*asked.weights != '\0')
    method.request.settings.push_back({.name = "weights", .text = asked.weights, .file = "reproduce"});
  if (method.request.name == "correction-ga" || method.request.name == "correction-aco") method.iterations = iterations;
  return method;
}

StudyCase make_case(std::size_t set, Task task, const std::string& file) {
  return {.name = case_name(set, task), .world = World(load_site(scenario_of(set, task, file)))};
}

StudyMethod exact_front() {
  StudyMethod exact = method(kMethods.front(), {});
  exact.front = true;
  return exact;
}

}  // namespace

std::array<std::string, kSets> find_sets(const std::string& folder) {
  std::array<std::string, kSets> files;
  std::vector<Fault> faults;
  for (std::size_t set = 0; set < kSets; ++set) {
    files[set] = (std::filesystem::path(folder) / fmt::format("set{}.csv", set + 1)).string();
    if (!std::filesystem::is_regular_file(files[set]))
      faults.push_back({.file = files[set],
                        .message = "no such file: the contest's points are not part of alate; name their folder with "
                                   "--data or ALATE_DATA"});
  }
  throw_if_any(std::move(faults));
  return files;
}

const Plan& Study::proven(std::size_t set, Task task) const {
  return exact.at(case_of(set, task), 0).runs.front().plan;
}

Study plan_study(const ReproduceOptions& options) {
  const auto files = find_sets(options.data);
  std::vector<StudyCase> exact;
  std::vector<StudyCase> straight;
  for (std::size_t set = 0; set < kSets; ++set) {
    for (const Task task : {Task::straight, Task::turning, Task::unreliable})
      exact.push_back(make_case(set, task, files[set]));
    straight.push_back(make_case(set, Task::straight, files[set]));
  }
  std::vector<StudyMethod> methods;
  for (const Asked& asked : kMethods) methods.push_back(method(asked, options.iterations));
  const std::uint64_t seeds = options.seeds.value_or(kSeeds);
  return {.exact = plan_experiment(std::move(exact), {exact_front()}, seeds),
          .methods = plan_experiment(std::move(straight), std::move(methods), seeds)};
}

std::optional<double> least_length(const Plan& proven, std::optional<int> corrections,
                                   std::optional<double> probability) {
  std::optional<double> least;
  for (const FrontPoint& point : proven.front) {
    if (corrections && point.corrections > *corrections) continue;
    if (probability && point.probability < *probability) continue;
    least = std::min(least.value_or(point.length_m), point.length_m);
  }
  return least;
}

}  // namespace alate::zhou2020
