#include "study/zhou2020/defects.hpp"

#include <fmt/core.h>

#include "study/zhou2020/judged_route.hpp"

namespace alate::zhou2020 {

namespace {

double direct_m(const Study& study, std::size_t set) {
  const Mission& mission = study.site(set, Task::straight).mission;
  return (mission.goal - mission.start).norm();
}

std::string lengths_measured(const Study& study) {
  return fmt::format(
      "From start to end of set 1 the straight line alone is {:.2f} m; the shortest route that keeps the limits is "
      "{:.2f} m.",
      direct_m(study, 0), study.proven(0, Task::straight).cost);
}

std::string carried_measured(const Study& study) {
  const Site& site = study.site(0, Task::straight);
  const double units = site.navigation->drift_vertical * direct_m(study, 0);
  return fmt::format("The straight line of set 1 gathers {:.1f} units; theta is {:g}.", units, site.navigation->theta);
}

std::string counted_twice_measured(const Study& study) {
  const StudyRun* first = study.trial(0, kAstar1).best();
  const StudyRun* second = study.trial(0, kAstar2).best();
  if (first == nullptr || second == nullptr)
    return "With one label a node our run of the published search found no route on set 1 with at least one of the "
           "weights.";
  return fmt::format("On set 1 our runs with weights 1 and 2 fly {:.2f} m and {:.2f} m with {} and {} corrections.",
                     first->metrics.length_m, second->metrics.length_m, first->metrics.corrections.value_or(0),
                     second->metrics.corrections.value_or(0));
}

std::string dropped_error_measured(const Study& study) {
  const StudyRun* kept = study.trial(0, kCorrectedAstar).best();
  const StudyRun* dropped = study.trial(0, kAstar1).best();
  const auto words = [](const StudyRun* run) {
    return run == nullptr ? std::string("no route") : fmt::format("{:.2f} m", run->metrics.length_m);
  };
  return fmt::format("Set 1: with the error kept {}, with it dropped {}, proven optimum {:.2f} m.", words(kept),
                     words(dropped), study.proven(0, Task::straight).cost);
}

std::string rate_measured(const Study& study) {
  const ParamValues& values = study.trial(0, kPaperGa).planner.parameters;
  return fmt::format("With the rates used here the best individual is crossed with {:g} and mutated with {:g}.",
                     values.number("pr2"), values.number("pm2"));
}

}  // namespace

std::vector<Defect> defects(const Study& study) {
  return {{.title = "Lengths shorter than the straight line",
           .text = "The paper’s routes are a sixth of the distance between start and end. They cannot be lengths of "
                   "routes between these points, in metres, whatever the limits.",
           .measured = lengths_measured(study)},
          {.title = "The error that a point does not reset is lost",
           .text = "The constraint model as printed forgets the error carried over from earlier legs and bounds the "
                   "whole flight by theta. Here each point resets one error and the other is carried on.",
           .measured = carried_measured(study)},
          {.title = "A second term that counts length again",
           .text = "The weights of the two errors sum to 1 and both grow with the length, so the term that should "
                   "stand for corrections is the length times a constant. With weights 1 the distance to go weighs "
                   "more than the way flown, so the search proves nothing.",
           .measured = counted_twice_measured(study)},
          {.title = "One label a node",
           .text = "The open and closed lists keep one value a node and drop the error. A longer arrival with less "
                   "error may be the only one that can go on.",
           .measured = dropped_error_measured(study)},
          {.title = "Text and formula of the adaptive rates differ",
           .text = "The text says that the best individual gets the highest rates of crossover and mutation; the "
                   "formula gives it the lowest. The formula is followed.",
           .measured = rate_measured(study)},
          {.title = "Error units are added to metres",
           .text = "The fitness as printed adds errors in units to heights and ranges in metres. Which weighs more is "
                   "a matter of units.",
           .measured = ""}};
}

}  // namespace alate::zhou2020
