#include "study/yin2021/reproduction.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "study/run_settings.hpp"
#include "study/yin2021/claims.hpp"
#include "study/yin2021/defects.hpp"
#include "study/yin2021/page.hpp"
#include "study/yin2021/summary.hpp"

namespace alate::yin2021 {

namespace {

RunSettings settings(const Study& study, const ReproduceOptions& options, int threads) {
  RunSettings all = run_settings(options.seeds.value_or(kSeeds), threads);
  all.emplace_back("seeds_of_readings", fmt::format("1 to {}", reading_seeds(options)));
  all.emplace_back("confidence", std::string("95 %, percentile bootstrap over the maps, 2000 samples"));
  all.emplace_back("cells", std::string("means over the maps of a size; sd: root of the mean variance within a map; "
                                        "bound: mean exact optimum"));
  for (const Size size : kBoth) {
    const Maps& maps = study.on(size).maps;
    all.emplace_back("maps_" + size_name(size), fmt::format("seeds {}", fmt::join(maps.seeds, " ")));
    all.emplace_back("passed_over_" + size_name(size), static_cast<std::int64_t>(maps.passed_over));
    all.emplace_back("layout " + size_name(size), scenario_text(size, maps.seeds.front()));
  }
  append_methods(study.on(kLarge).main, all);
  append_methods(study.on(kLarge).readings, all);
  return all;
}

void append_cells(const SizeStudy& of_size, const std::string& name, Reproduction& result) {
  for (const Experiment* experiment : {&of_size.main, &of_size.readings}) {
    for (std::size_t m = 0; m < experiment->methods.size(); ++m) {
      result.cells.push_back(cell_over_maps(of_size, *experiment, m));
      result.cells.back().case_name = name;
    }
  }
  for (std::size_t map = 0; map < of_size.maps.seeds.size(); ++map)
    for (const StudyMethod& method : of_size.main.methods)
      result.details.push_back(cell_on_map(of_size, map, method.name));
}

}  // namespace

std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options) {
  Study study = plan_study(options);
  std::vector<Experiment*> experiments;
  for (SizeStudy& of_size : study.sizes) {
    experiments.push_back(&of_size.main);
    experiments.push_back(&of_size.readings);
  }
  if (!run_experiments(experiments, executor, options)) return std::nullopt;
  Reproduction result{.paper = "yin2021",
                      .title = "Yin et al. 2021, adaptive multi-heuristic ant colony on a height grid",
                      .notes = notes(),
                      .claims = claims(study),
                      .defects = defects(study),
                      .settings = settings(study, options, executor.threads())};
  for (std::size_t i = 0; i < kSizes.size(); ++i) append_cells(study.sizes[i], size_name(i), result);
  result.page = page_html(study, result);
  return result;
}

}  // namespace alate::yin2021
