#include "study/mai2023/study.hpp"

#include "alate/data/scenario_file.hpp"

namespace alate::mai2023 {

namespace {

std::vector<StudyCase> cases(const char* combine) {
  std::vector<StudyCase> all;
  for (const Scene scene : kScenes) {
    const std::string name = kSceneNames[scene];
    all.push_back(
        {.name = name, .world = World(load_site(parse_scenario(scenario_text(scene, combine), "scene " + name)))});
  }
  return all;
}

}  // namespace

std::uint64_t reading_seeds(const ReproduceOptions& options) {
  return options.seeds.value_or(kSeeds) / kSeedsToReadings;
}

Study plan_study(const ReproduceOptions& options) {
  Study study{.main = plan_experiment(cases(kSum), main_methods(options.iterations), options.seeds.value_or(kSeeds)),
              .readings = {},
              .optimum = {}};
  for (const Scene scene : kScenes)
    study.main.trials[scene * study.main.methods.size() + method_index(study.main, kGreedy)].runs.resize(1);
  for (std::size_t r = 1; r < readings().size(); ++r)
    study.readings.push_back(plan_experiment(
        cases(readings()[r].combine), reading_methods(readings()[r], options.iterations), reading_seeds(options)));
  for (const Scene scene : kScenes) {
    const Trial& trial = study.trial(scene, kMai);
    study.optimum[scene] = least_fitness(study.main.cases[scene].world, trial.planner.parameters).value();  // has ways
  }
  return study;
}

const Trial& Study::trial(Scene scene, std::string_view method) const {
  return main.at(scene, method_index(main, method));
}

const Trial& Study::trial(std::size_t reading, Scene scene, std::string_view method) const {
  const Experiment& experiment = reading == 0 ? main : readings[reading - 1];
  return experiment.at(scene, method_index(experiment, method));
}

}  // namespace alate::mai2023
