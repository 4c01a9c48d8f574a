#include "rivals.hpp"

#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <sched.h>

#include <array>

namespace alate::peers {

namespace {

namespace og = ompl::geometric;

/// Solved in slices, after each of which the best way so far is handed over: an eighth longer each time, so that what
/// is found is told at most an eighth of its time later.
void run_in_slices(ob::Planner& planner, const FlightProblem& problem, Recorder& recorder) {
  constexpr double kFirst = 0.002;
  constexpr double kGrowth = 1.06;
  planner.setProblemDefinition(problem.definition);
  planner.setup();
  for (double until = kFirst * recorder.seconds(); recorder.is_on(); until *= kGrowth) {
    const double slice = std::min(until, recorder.seconds());
    planner.solve(ob::PlannerTerminationCondition([&] { return recorder.time_s() >= slice; }));
    if (problem.definition->hasExactSolution()) recorder.offer(way_of(problem.definition->getSolutionPath()));
    problem.definition->clearSolutionPaths();
  }
}

/// Motions as long as the map: OMPL's own range, a fifth of it, leaves both without a route for many seconds.
template <class Planner>
void run_tree(const FlightLegs& legs, Recorder& recorder) {
  const FlightProblem problem = flight_problem(legs);
  Planner planner(problem.information);
  planner.setRange(problem.space->getMaximumExtent());
  run_in_slices(planner, problem, recorder);
}

void run_bit_star(const FlightLegs& legs, Recorder& recorder) {
  const FlightProblem problem = flight_problem(legs);
  og::BITstar planner(problem.information);
  run_in_slices(planner, problem, recorder);
}

/// Its threads share one core, as everyone has one.
void stay_on_one_core() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &cores);
  sched_setaffinity(0, sizeof cores, &cores);
}

void run_anytime_path_shortening(const FlightLegs& legs, Recorder& recorder) {
  stay_on_one_core();
  const FlightProblem problem = flight_problem(legs);
  og::AnytimePathShortening planner(problem.information);
  ob::PlannerPtr inner = std::make_shared<og::RRTConnect>(problem.information);
  planner.addPlanner(inner);
  planner.setProblemDefinition(problem.definition);
  planner.setup();
  // Asked often, by all its threads: a good moment to see whether there is a new way.
  std::atomic<std::size_t> seen = 0;
  std::mutex mutex;
  const auto look = [&] {
    const std::unique_lock lock(mutex, std::try_to_lock);
    const std::size_t count = lock ? problem.definition->getSolutionCount() : 0;
    if (count <= seen) return;
    seen = count;
    recorder.offer(way_of(problem.definition->getSolutionPath()));
  };
  planner.solve(ob::PlannerTerminationCondition([&] {
    look();
    return !recorder.is_on();
  }));
}

constexpr std::array kRivals{
    Rival{"rrtconnect-restarts", "RRTConnect restarted, ways reduced and shortcut in the direction of travel",
          [](const FlightLegs& legs, Recorder& recorder) { run_restarts(legs, recorder, false); }},
    Rival{"rrtconnect-elites", "the same, and half of the time for perturbing and shortcutting the six best ways",
          [](const FlightLegs& legs, Recorder& recorder) { run_restarts(legs, recorder, true); }},
    Rival{"anytime-path-shortening", "AnytimePathShortening with RRTConnect and hybridization",
          run_anytime_path_shortening},
    Rival{"rrt-star", "RRT*", run_tree<og::RRTstar>},
    Rival{"informed-rrt-star", "Informed RRT*", run_tree<og::InformedRRTstar>},
    Rival{"bit-star", "BIT*", run_bit_star},
};

}  // namespace

std::span<const Rival> rivals() { return kRivals; }

Way way_of(const ob::PathPtr& path) {
  Way way;
  if (auto* states = dynamic_cast<og::PathGeometric*>(path.get()))
    for (const ob::State* state : states->getStates()) way.push_back(at(state));
  return way;
}

}  // namespace alate::peers
