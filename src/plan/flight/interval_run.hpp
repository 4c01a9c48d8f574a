// The work of the interval search on one flight, whoever asks for it: the planner once, a Session again and again.
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "search/interval/flight_pool.hpp"
#include "space/flight/flight_air.hpp"

namespace alate {

/// Weight of the cost-to-go, and width of bins in their usual width.
struct IntervalPass {
  double epsilon = 2.5;
  double bin = 1;
  bool by_cost = true;  ///< Does it take a cheaper label to drop another in its bin?
  std::uint64_t most_nodes = 1'000'000;
};

/// Ways from one start to one goal, and the best flight over them. An iteration is a bit of a search, or a round of
/// changes to a way that is known.
class IntervalRun {
 public:
  static constexpr std::uint64_t kIterations = 100;  ///< Where neither a budget nor a time limit is given.
  /// Any way will do.
  static constexpr IntervalPass kHasty{.epsilon = 16, .bin = 1.5, .by_cost = false};

  /// From the start of `mission`; `before` leads there, or is empty. All but `before` must outlive this.
  IntervalRun(const FlightAir& air, Mission mission, RunContext& run, Route before = {});

  /// The end of the flight, with the usual share of the goal's ball spent on altitude.
  FlightEnd end() const;

  /// Takes a way that was found elsewhere, which must lead from the start into the goal's ball. False, and nothing is
  /// taken, where no altitudes keep the band.
  bool add(const Track& track);
  /// The same, for a way that one search finds. Its expansions are counted in `plan`.
  bool search(IntervalAStar& astar, const IntervalPass& pass, Plan& plan);

  /// Takes the first way that can be had, searching from both ends if need be; false if none is found.
  bool search_first(ClimbField& to_go, IntervalAStar& astar, Plan& plan);

  /// Altitudes for the way that seems best; into `plan` if it is better than what is there.
  void fly_best(Plan& plan);

  /// Searches until there is a way; then searches on and changes what was found, by turns, until the budget is used or
  /// no route is proven. `to_go`, which guides `astar`, grows as it is asked for. `note_bound`, if given, is called
  /// when the first iteration is over, and again once there is a route.
  void improve(ClimbField& to_go, IntervalAStar& astar, Plan& plan,
               const std::function<void(Plan&)>& note_bound = nullptr);

 private:
  static constexpr int kTrials = 1000;  ///< Of changes, an iteration.

  IntervalSearchOptions options_of(const IntervalPass& pass) const;
  std::optional<Track> find_first(ClimbField& to_go, IntervalAStar& astar, Plan& plan);
  FlightPath path_of(const Track& track) const;
  void search_on(ClimbField& to_go, IntervalAStar& astar, Plan& plan);
  void search_shortest(Plan& plan);
  bool is_worth_flying(const Plan& plan) const;

  const FlightAir& air_;
  Mission mission_;
  RunContext& run_;
  Route before_;
  Stream random_;
  FlightPool pool_;
  double flown_ = kInfinity;  ///< What the way cost, as far as it was known, for which altitudes were chosen last.
  bool searching_ = false;    ///< A search has begun and not ended.
  bool looked_for_first_ = false;
  bool looked_for_shortest_ = false;
  std::size_t pass_ = 0;
};

/// What is said where a run ends without a route.
inline constexpr std::string_view kNoFlight = "no string of arcs and straight pieces leads to the goal";

}  // namespace alate
