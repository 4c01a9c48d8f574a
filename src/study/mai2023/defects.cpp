#include "study/mai2023/defects.hpp"

#include <fmt/core.h>

#include "study/judgement.hpp"
#include "study/mai2023/fitness.hpp"
#include "study/mai2023/trail_figures.hpp"

namespace alate::mai2023 {

namespace {

/// "Simple: ... Medium: ..." for those that say something.
template <class OnScene>
std::string on_scenes(const OnScene& on_scene) {
  std::string words;
  for (const Scene scene : kScenes) {
    const std::string said = on_scene(scene);
    if (!said.empty()) words += fmt::format("{}{}: {}.", words.empty() ? "" : " ", kSceneNames[scene], said);
  }
  return words;
}

std::string change_of(const Trial& from, const Trial& to, Measure measure) {
  const auto found = change(from, to, measure);
  return found ? change_words(*found, words_of(measure).unit) : "not known";
}

std::string gap_words(const Study& study, Scene scene, const char* method) {
  const auto gap = gap_percent(study, scene, method);
  return gap ? fmt::format("{} {:.1f} %", method, *gap) : fmt::format("{} no route", method);
}

std::string gaps_measured(const Study& study) {
  return "Mean F above the least of the lattice: " + on_scenes([&](Scene scene) {
           std::string words;
           for (const char* method : {kAco, kMai, kAcoBlind, kMaiBlind, kGreedy, kImprovedF})
             words += (words.empty() ? "" : ", ") + gap_words(study, scene, method);
           return words;
         });
}

std::string strategies_measured(const Study& study) {
  return "Change of F from the baseline: " + on_scenes([&](Scene scene) {
           const auto from_aco = [&](const char* method) {
             return change_of(study.trial(scene, kAco), study.trial(scene, method), kFitness);
           };
           return fmt::format("strategy 1 alone {}, strategy 2 alone {}, both {}", from_aco(kSelection),
                              from_aco(kUpdate), from_aco(kMai));
         });
}

std::string pheromone_measured(const Study& study) {
  return "Change of F by pheromone: " + on_scenes([&](Scene scene) {
           return fmt::format("{} {}, {} {}", kAco,
                              change_of(study.trial(scene, kAcoBlind), study.trial(scene, kAco), kFitness), kMai,
                              change_of(study.trial(scene, kMaiBlind), study.trial(scene, kMai), kFitness));
         });
}

std::string jump_measured(const Study& study) {
  const Trial& any = study.trial(kSimple, kMai);
  const std::size_t count = any.runs.front().plan.history.size();
  if (count < 40) return "";
  const std::size_t jump = (7 * count + 9) / 10;  // the first n with 10 n >= 7 N
  const std::size_t around = count / 20;
  const double initial = any.planner.parameters.number("q0");
  return fmt::format(
      "With {} iterations q0 falls to {:.3f} and jumps to {:.3f}. Mean F of the ants in the {} iterations before and "
      "after: {}",
      count, scheduled_q0(initial, jump - 1, count), scheduled_q0(initial, jump, count), around,
      on_scenes([&](Scene scene) -> std::string {
        const auto before = ants_mean(study.trial(scene, kMai), jump + 1 - around, jump);
        const auto after = ants_mean(study.trial(scene, kMai), jump + 1, jump + around);
        return before && after ? fmt::format("{:.1f} and {:.1f}", *before, *after) : "";
      }));
}

std::string decay_measured(const Study& study) {
  return "Had lambda not decayed, deposits of the last tenth of the iterations would differ by, on average: " +
         on_scenes([&](Scene scene) -> std::string {
           const auto effect = effect_of_decay_percent(study.trial(scene, kMai));
           return effect ? fmt::format("{:.2f} %", *effect) : "";
         });
}

std::string fixed_points_measured(const Study& study) {
  std::size_t little = 0;
  while (readings()[little].name != kLittlePheromone) ++little;
  const std::string words = on_scenes([&](Scene scene) -> std::string {
    const auto chosen = fixed_points(study.trial(scene, kMai));
    const auto low = fixed_points(study.trial(little, scene, kMai));
    if (!chosen || !low) return "";
    return fmt::format("{:.2f} to {:.2f} with Q = 100, {:.2f} to {:.2f} with Q = 10, where F changes by {}",
                       chosen->least, chosen->greatest, low->least, low->greatest,
                       change_of(study.trial(scene, kMai), study.trial(little, scene, kMai), kFitness));
  });
  return "Trails start at 1. Those of the updated path tend to, over all iterations: " + words;
}

std::string parts_measured(const Study& study) {
  return "From the baseline to the paper's method: " + on_scenes([&](Scene scene) -> std::string {
           const auto fall = [&](Measure measure) -> std::optional<double> {
             const auto aco = summary_of(study.trial(scene, kAco), measure);
             const auto mai = summary_of(study.trial(scene, kMai), measure);
             return aco && mai ? std::optional(aco->mean - mai->mean) : std::nullopt;
           };
           const auto fitness = fall(kFitness);
           const auto length = fall(kLength);
           if (!fitness || !length) return "";
           const Fitness least = fitness_of(study.optimum[scene].places);
           return fmt::format(
               "F falls by {:.1f}, the length by {:.1f} of it; the least F is made of length {:.1f}, heights {:.1f} "
               "and "
               "turns {:.1f}",
               *fitness, *length, least.length, least.heights, least.turns);
         });
}

std::string dead_ends_measured(const Study& study) {
  return "Ants that ended in one: " + on_scenes([&](Scene scene) {
           return fmt::format("{} {:.1f} %, {} {:.1f} %", kAco, dead_ends_percent(study.trial(scene, kAco)), kMai,
                              dead_ends_percent(study.trial(scene, kMai)));
         });
}

std::string changes_measured(const Study& study) {
  return "Last change, and F above the least: " + on_scenes([&](Scene scene) {
           std::string words;
           for (const char* method : {kAco, kMai, kMaiBlind, kImprovedF}) {
             const auto last = summary_of(study.trial(scene, method), kIteration);
             if (last)
               words += fmt::format("{}iteration {:.0f}, {}", words.empty() ? "" : "; ", last->mean,
                                    gap_words(study, scene, method));
           }
           return words;
         });
}

std::vector<Defect> of_the_comparison(const Study& study) {
  return {
      {"The baseline is the weakest there is",
       "The oldest ant system, where all ants deposit alike and none is favoured, is the only one the paper compares "
       "with. Choice by q0 is that of Ant Colony System (1997), deposits of the best ant between two bounds are those "
       "of MAX-MIN Ant System (2000). Each strategy by itself, beside both:",
       strategies_measured(study)},
      {"No exact answer and no plain walk stand beside it",
       "From plane to plane the least F can be found exactly in a fraction of a second. That tells how much is left to "
       "gain; walks without pheromone, and one greedy walk, tell how much the colony itself gains.",
       gaps_measured(study)},
      {"What pheromone does", "The same walks with and without it.", pheromone_measured(study)},
      {"An early last change may be a colony that is stuck",
       "The iteration number says when a colony stopped to gain, not how good it was by then.",
       changes_measured(study)},
      {"A lower F is not much of a shorter route",
       "F adds a height and an angle for each leg. Their sums grow with the number of legs, and their units and "
       "weights, "
       "which are not known, decide what is the best route.",
       parts_measured(study)},
  };
}

std::vector<Defect> of_the_rules(const Study& study) {
  return {
      {"q0 jumps", "Eq. (15) as printed does not join at 0.7 N: q0 falls to 0.3 of what it was, and jumps to 0.5.",
       jump_measured(study)},
      {"The weight of the global best falls where it should rise",
       "lambda shrinks by a tenth every 100 iterations, so late deposits look less to the best route of all, while the "
       "text wants refinement late.",
       decay_measured(study)},
      {"A used path can lose pheromone",
       "As printed, only the updated path evaporates. Its trails tend to the deposit over rho: where that is below "
       "their level, the best path of an iteration ends with less than paths nobody flew. Bounds of 0.1 and 10 act "
       "only where that point lies beyond them.",
       fixed_points_measured(study)},
      {"Constants that do nothing",
       "P and K of eqs. (12), (13) stand in all candidates alike and cancel in every choice.", ""},
      {"One and a kilometre are added",
       "Eqs. (12), (13) add heights and distances to 1. In cells instead of km the weights of the choices are others: "
       "see the reading \"factors in cells\". The 1 under the first root is kept as printed; our step is 1 km.",
       ""},
      {"Nothing is said of dead ends, nor of what a broken constraint costs",
       "An ant without candidates is dropped here, and constraints take candidates away. S asks that the whole leg "
       "clear the ground: nodes alone would let legs cut ridges. Other answers are among the readings.",
       dead_ends_measured(study)},
  };
}

}  // namespace

std::vector<Defect> defects(const Study& study) {
  std::vector<Defect> all = of_the_comparison(study);
  for (Defect& defect : of_the_rules(study)) all.push_back(std::move(defect));
  return all;
}

}  // namespace alate::mai2023
