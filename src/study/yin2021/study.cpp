#include "study/yin2021/study.hpp"

#include <algorithm>

namespace alate::yin2021 {

namespace {

SizeStudy plan_size(Size size, const ReproduceOptions& options, std::size_t count) {
  Maps maps = draw_maps(size, count);
  Experiment main = plan_experiment(maps.cases, main_methods(options.iterations), options.seeds.value_or(kSeeds));
  Experiment readings = plan_experiment(maps.cases, reading_methods(options.iterations), reading_seeds(options));
  return {.maps = std::move(maps), .main = std::move(main), .readings = std::move(readings)};
}

}  // namespace

std::uint64_t reading_seeds(const ReproduceOptions& options) {
  return std::max<std::uint64_t>(1, options.seeds.value_or(kSeeds) / kSeedsToReadings);
}

Study plan_study(const ReproduceOptions& options, std::size_t maps) {
  return {.sizes = {plan_size(kSmall, options, maps), plan_size(kLarge, options, maps)}};
}

const Trial& SizeStudy::trial(std::size_t map, std::string_view method) const {
  const bool is_main = std::ranges::find(main.methods, method, &StudyMethod::name) != main.methods.end();
  const Experiment& experiment = is_main ? main : readings;
  return experiment.at(map, method_index(experiment, method));
}

Comparison Study::compare(Size size, std::size_t reading) const {
  const SizeStudy& of_size = on(size);
  if (reading == 0) {
    const Experiment& main = of_size.main;
    return {.of_li = &main, .li = method_index(main, kLi), .of_yin = &main, .yin = method_index(main, kYin)};
  }
  const Experiment& runs = of_size.readings;
  const auto index = [&](const char* method, const std::vector<Setting>& own) {
    return method_index(runs, method_name(method, readings()[own.empty() ? 0 : reading]));
  };
  return {.of_li = &runs,
          .li = index(kLi, readings()[reading].li),
          .of_yin = &runs,
          .yin = index(kYin, readings()[reading].yin)};
}

}  // namespace alate::yin2021
