// RRTConnect restarted until the time is up: the fairest rival.
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rivals.hpp"
#include "shortcuts.hpp"

namespace alate::peers {

namespace {

namespace og = ompl::geometric;

constexpr std::array kRanges{0.2, 1.0, 0.1};  ///< Longest motions, as shares of the extent; the first is OMPL's own.
constexpr std::size_t kElites = 6;
constexpr int kPatience = 100;       ///< Attempts in vain before a way counts as short; and in one round of perturbing.
constexpr int kMostPatience = 1000;  ///< Likewise for a way no dearer than kPromising times the best.
constexpr double kPromising = 1.2;
constexpr double kFirstPatience_s = 0.02;  ///< For one start: a tree that took a bad turn is better given up.
constexpr double kMorePatience = 1.5;      ///< Times as much after each that found nothing.

class Restarts {
 public:
  Restarts(const FlightLegs& legs, Recorder& recorder, bool elites)
      : legs_(legs), recorder_(recorder), perturbs_(elites), problem_(flight_problem(legs)) {}

  void run() {
    while (recorder_.is_on()) {
      const double from = recorder_.time_s();
      const bool polish = perturbs_ && !elites_.empty() && polished_s_ < started_s_;
      if (polish)
        better_an_elite();
      else
        start_anew();
      (polish ? polished_s_ : started_s_) += recorder_.time_s() - from;
    }
  }

 private:
  void start_anew() {
    problem_.definition->clearSolutionPaths();
    // Only places from which a better way than the best one is possible.
    if (!elites_.empty()) problem_.space->set_most_length(legs_.most_length(elites_.front().cost()));
    og::RRTConnect planner(problem_.information);
    planner.setRange(kRanges[starts_++ % kRanges.size()] * problem_.space->getMaximumExtent());
    planner.setProblemDefinition(problem_.definition);
    planner.setup();
    const double until = recorder_.time_s() + patience_s_;
    planner.solve(ob::PlannerTerminationCondition([&] { return !recorder_.is_on() || recorder_.time_s() > until; }));
    if (!problem_.definition->hasExactSolution()) {
      patience_s_ *= kMorePatience;
      return;
    }
    auto path = std::static_pointer_cast<og::PathGeometric>(problem_.definition->getSolutionPath());
    og::PathSimplifier(problem_.information).reduceVertices(*path);
    ShorterWay way(legs_, way_of(path));
    shorten(way);
    if (std::isfinite(way.cost())) keep(std::move(way));
  }

  /// A little, and a way that may become the best one much more.
  void shorten(ShorterWay& way) {
    shorten(way, kPatience);
    if (way.cost() < kPromising * best_) shorten(way, kMostPatience);
  }

  void shorten(ShorterWay& way, int patience) {
    constexpr double kWorthwhile = 1e-4;  // of the cost
    for (int vain = 0; vain < patience && recorder_.is_on(); ++vain) {
      const double before = way.cost();
      if (way.shortcut(random_) && way.cost() < (1 - kWorthwhile) * before) vain = 0;
    }
  }

  void better_an_elite() {
    // The best one every other round, the second one every fourth, ...
    std::size_t rank = 0;
    while (rank + 1 < elites_.size() && random_.uniformBool()) ++rank;
    ShorterWay& way = elites_[rank];
    for (int i = 0; i < kPatience && recorder_.is_on(); ++i) {
      if (random_.uniformBool())
        way.perturb(random_);
      else
        way.shortcut(random_);
    }
    note(way);
    std::ranges::stable_sort(elites_, {}, &ShorterWay::cost);
  }

  void keep(ShorterWay way) {
    note(way);
    elites_.push_back(std::move(way));
    std::ranges::stable_sort(elites_, {}, &ShorterWay::cost);
    if (elites_.size() > kElites) elites_.pop_back();
  }

  void note(const ShorterWay& way) {
    if (way.cost() >= best_) return;
    best_ = way.cost();
    recorder_.offer(way.way());
  }

  const FlightLegs& legs_;
  Recorder& recorder_;
  bool perturbs_;
  FlightProblem problem_;
  ompl::RNG random_;
  std::vector<ShorterWay> elites_;
  double best_ = std::numeric_limits<double>::infinity();
  std::size_t starts_ = 0;
  double patience_s_ = kFirstPatience_s;
  double polished_s_ = 0;
  double started_s_ = 0;
};

}  // namespace

void run_restarts(const FlightLegs& legs, Recorder& recorder, bool elites) { Restarts(legs, recorder, elites).run(); }

}  // namespace alate::peers
