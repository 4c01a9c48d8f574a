// A genetic algorithm over correction points: Zhou et al. 2020 as published, and made good.
#include <cmath>

#include "ga/fixed_breeder.hpp"
#include "ga/string_breeder.hpp"
#include "plan/correction/correction_ga_parameters.hpp"
#include "plan/correction/correction_heuristic.hpp"
#include "plan/correction/correction_planners.hpp"

namespace alate {

namespace {

/// Longest leg that an aircraft without error can fly to a point; the direct way where nothing limits it.
double longest_leg_m(const CorrectionGraph& graph) {
  const double direct_m = graph.length(graph.start(), graph.goal());
  double longest = 0;
  for (const PointKind to : {PointKind::vertical, PointKind::horizontal})
    longest = std::max(longest, graph.leg(PointKind::vertical, to).reach_m(0));
  return longest > 0 ? std::min(longest, direct_m) : direct_m;
}

class CorrectionGa {
 public:
  explicit CorrectionGa(ParamValues values) : values_(std::move(values)) {}

  /// The chromosomes of the first population, strings of fixed length.
  std::vector<std::vector<int>> first(const Problem& problem, std::size_t most, RunContext& run) const {
    std::vector<std::vector<int>> chromosomes;
    plan_on_corrections(problem, run, values_.number("corridor"), [&](const CorrectionTask& task) {
      with_chromosomes(problem, task, price_of(problem, task), [&](const FixedBreeder& breeder) {
        for (std::size_t a = 0; a < most; ++a) {
          Stream stream(run.seed(), 1, a);
          std::vector<int>& ids = chromosomes.emplace_back();
          for (const CorrectionGraph::Node node : breeder.first(stream, run).genes) ids.push_back(task.graph.id(node));
        }
      });
      return CorrectionFound{};
    });
    return chromosomes;
  }

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_on_corrections(problem, run, values_.number("corridor"), [&](const CorrectionTask& task) {
      const RoutePrice price = price_of(problem, task);
      Evolved evolved = values_.text("strings") == "fixed" ? breed_chromosomes(problem, task, price, run)
                                                           : breed_strings(task, price, run);
      const std::uint64_t births = run.iterations() * count("population");
      return CorrectionFound{.found = evolved.best.feasible(),
                             .points = std::move(evolved.best.genes),
                             .candidates = births,
                             .expansions = births,
                             .history = std::move(evolved.history)};
    });
  }

 private:
  std::size_t count(std::string_view name) const { return static_cast<std::size_t>(values_.integer(name)); }

  RoutePrice price_of(const Problem& problem, const CorrectionTask& task) const {
    if (problem.prefer == Preference::corrections) return task.price;
    const double w = values_.number("w");
    return {.per_m = w, .per_correction = (1 - w) * (values_.flag("scaled") ? longest_leg_m(task.graph) : 1)};
  }

  EvolutionOptions evolution() const {
    return {.population = count("population"), .iterations = static_cast<std::uint64_t>(values_.integer("iterations"))};
  }

  Evolved breed_strings(const CorrectionTask& task, const RoutePrice& price, RunContext& run) const {
    const RelaxedToGo to_go(task.graph, RelaxedToGo::Extent::everywhere, run);
    if (to_go.stopped()) return {};
    const Successors successors(task.graph, to_go, count("candidates"), run);
    const StringWindows windows(task.graph, successors, price,
                                {.most_old = count("window_old"), .most_new = count("window_new")});
    const StringBreeder breeder(task.graph, to_go, successors, windows, price,
                                {.crossover = values_.number("crossover"),
                                 .mutation = values_.number("mutation"),
                                 .polish = values_.number("polish"),
                                 .temperature_m = values_.number("temperature"),
                                 .spread = values_.number("spread"),
                                 .tournament = count("tournament"),
                                 .step_limit = count("step_limit"),
                                 .step_backs = count("step_backs")});
    return evolve(breeder, evolution(), run);
  }

  Evolved breed_chromosomes(const Problem& problem, const CorrectionTask& task, const RoutePrice& price,
                            RunContext& run) const {
    Evolved evolved;
    with_chromosomes(problem, task, price,
                     [&](const FixedBreeder& breeder) { evolved = evolve(breeder, evolution(), run); });
    return evolved;
  }

  template <class Use>
  void with_chromosomes(const Problem& problem, const CorrectionTask& task, const RoutePrice& price,
                        const Use& use) const {
    const double direct_m = task.graph.length(task.graph.start(), task.graph.goal());
    const GeneRectangle rectangle(task.graph, values_.number("rectangle_width") * direct_m, count("cells"));
    const SampledCost cost = sampled_cost(problem, price);
    const FixedBreeder breeder(task.graph, rectangle, cost,
                               {.genes = genes(task.graph),
                                .sorted = values_.text("gene_order") == "along",
                                .crossover = rate("pr1", "pr2"),
                                .mutation = rate("pm1", "pm2"),
                                .elite = count("elite")});
    use(breeder);
  }

  SampledCost sampled_cost(const Problem& problem, const RoutePrice& price) const {
    return {.samples = count("samples"),
            .horizontal = values_.number("w1"),
            .metres_a_unit = values_.number("error_metres"),
            .only_excess = values_.text("error") == "excess",
            .over_altitude = values_.number("w1_altitude"),
            .over_range = values_.number("w2_range"),
            .with_goal = values_.flag("goal_in_cost"),
            .goal = price,
            .ceiling_m = problem.world.site().band.ceiling_amsl_m,
            .range_m = problem.vehicle.range_m};
  }

  AdaptiveRate rate(std::string_view high, std::string_view low) const {
    const bool adaptive = values_.text("rates") == "adaptive";
    return {.high = values_.number(high), .low = values_.number(adaptive ? low : high)};
  }

  std::size_t genes(const CorrectionGraph& graph) const {
    constexpr double kMore = 2.5;
    if (const std::size_t given = count("genes"); given != 0) return given;
    return static_cast<std::size_t>(
        std::ceil(kMore * graph.length(graph.start(), graph.goal()) / longest_leg_m(graph)));
  }

  ParamValues values_;
};

}  // namespace

std::vector<std::vector<int>> first_chromosomes(const Problem& problem, const ParamValues& parameters,
                                                std::size_t count) {
  Executor alone(1);
  RunContext run(alone, {});
  return CorrectionGa(parameters).first(problem, count, run);
}

PlannerEntry correction_ga_entry() {
  return {.name = "correction-ga",
          .help = "A genetic algorithm over correction points: as published in 2020, and made good.",
          .can = {.anytime = true, .terrain = true, .space = "correction points"},
          .presets = correction_ga_presets(),
          .parameters = ParamTable(correction_ga_parameters()),
          .refuses = heuristic_refusal,
          .make = [](const ParamValues& values) { return Planner(CorrectionGa(values)); }};
}

}  // namespace alate
