#include "plan/flight/interval_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plan/flight/flight_ends.hpp"
#include "plan/flight/flight_plan.hpp"
#include "search/interval/both_ends.hpp"
#include "search/interval/flight_profile.hpp"

namespace alate {

namespace {

/// After the first way, one search each; few of the last ones end before the time does. Wide bins come first: they find
/// other ways round soonest.
constexpr std::array kPasses{IntervalPass{1.5, 4},  IntervalPass{1.3, 3},    IntervalPass{1.3, 2},
                             IntervalPass{1.05, 3}, IntervalPass{1.05, 2},   IntervalPass{1.15, 1},
                             IntervalPass{1.05, 1}, IntervalPass{1.15, 0.5}, IntervalPass{1.05, 0.5}};

/// Expansions of an iteration: they take about as long as the changes of another one.
constexpr std::uint64_t kSlice = 700;
/// The search after the first way seldom needs more, and mostly finds a much better one.
constexpr std::uint64_t kSecond = 12'000;
/// Expansions of the first search, before it goes on from both ends.
constexpr std::uint64_t kAlone = 300;
/// Parts of the estimated cost of the flight: as far as that from either end lies the ground between them. To know the
/// cost-to-go everywhere takes longer than most searches.
constexpr double kAround = 1.25;
/// Parts of the first search's bins: the narrowest from which the ends are searched anew.
constexpr double kNarrowest = 0.15;

/// Bins; of ways that are nearer to each other only one is bettered.
constexpr double kApart = 3;

/// The share of the ball that a way which ends at `place` leaves for altitude.
FlightEnd end_at(FlightEnd end, const Vec2& place) {
  if (end.tolerance_m <= 0) return end;
  constexpr double kRounding_m = 1e-9;
  const double beside = (place - end.place()).norm() + kRounding_m;
  if (beside < end.tolerance_m) end.tilt_rad = std::acos(beside / end.tolerance_m);
  return end;
}

}  // namespace

IntervalRun::IntervalRun(const FlightAir& air, Mission mission, RunContext& run, Route before)
    : air_(air),
      mission_(std::move(mission)),
      run_(run),
      before_(std::move(before)),
      random_(run.seed(), 0, 0),
      pool_(kTrials, kApart * bin_width((mission_.goal - mission_.start).norm(), air.band.radius_m())) {}

FlightEnd IntervalRun::end() const { return flight_end(mission_.goal, mission_.tolerance_m); }

bool IntervalRun::add(const Track& track) {
  if (track.empty()) return false;
  const Vec2 last = track.back().end().position();
  const FlightEnd end = end_at(this->end(), last);
  constexpr double kRounding_m = 1e-6;
  if ((last - end.place()).norm() > end.tolerance_m + kRounding_m) return false;
  FlightPath path(air_.cost, end, track, mission_.start.z());
  if (!std::isfinite(path.cost())) return false;
  pool_.add(std::move(path));
  return true;
}

IntervalSearchOptions IntervalRun::options_of(const IntervalPass& pass) const {
  const double bin = bin_width((mission_.goal - mission_.start).norm(), air_.band.radius_m());
  // A label that reaches little higher than another in its bin leads to no other ways. In a narrow band over steep
  // ground labels that differ by a few metres are what searches drown in.
  constexpr double kAlike = 0.3;
  constexpr double kLeast_m = 1.5;
  return {.epsilon = pass.epsilon,
          .bin_m = bin * pass.bin,
          .most_nodes = pass.most_nodes,
          .alike_m = std::max(kLeast_m, kAlike * bin * pass.bin * std::min(1.0, air_.band.slopes().climb)),
          .by_cost = pass.by_cost};
}

bool IntervalRun::search(IntervalAStar& astar, const IntervalPass& pass, Plan& plan) {
  const auto track = astar.find(flight_start(mission_), end(), options_of(pass), run_);
  plan.counters["expansions"] += astar.expansions();
  if (!track) return false;
  FlightPath path = path_of(*track);
  path.shorten(run_);
  pool_.add(std::move(path));
  return true;
}

FlightPath IntervalRun::path_of(const Track& track) const { return {air_.cost, end(), track, mission_.start.z()}; }

bool IntervalRun::search_first(ClimbField& to_go, IntervalAStar& astar, Plan& plan) {
  looked_for_first_ = true;
  if (const auto track = find_first(to_go, astar, plan)) pool_.add_bettered(path_of(*track), random_, run_);
  return !pool_.empty();
}

/// From the start alone at first, which mostly is enough; then from both ends, over the ground between them; at last
/// over all the ground there is.
std::optional<Track> IntervalRun::find_first(ClimbField& to_go, IntervalAStar& astar, Plan& plan) {
  const IntervalSearchOptions options = options_of(kHasty);
  astar.begin(flight_start(mission_), end(), options);
  auto track = astar.go_on(kAlone, run_);
  plan.counters["expansions"] += astar.expansions();
  if (track) return track;
  to_go.grow_to(run_, kAround * to_go(mission_.start));
  ClimbField to_start = to_go.homeward();
  to_start.grow(run_, mission_.goal);
  to_start.grow_to(run_, kAround * to_start(mission_.goal));
  for (const bool everywhere : {false, true}) {
    if (!run_.keep_going()) break;
    if (everywhere) {
      to_go.grow(run_);
      to_start.grow(run_);
    }
    BothEnds both(astar, air_.cost, to_start, everywhere ? kNarrowest * options.bin_m : options.bin_m);
    track = both.find(flight_start(mission_), end(), options, run_);
    plan.counters["expansions"] += both.expansions();
    if (track) break;
  }
  return track;
}

/// Where more is to go than the best way costs, no better one leads.
void IntervalRun::search_on(ClimbField& to_go, IntervalAStar& astar, Plan& plan) {
  if (!searching_) {
    to_go.grow_to(run_, pool_.empty() ? kInfinity : pool_.best().cost());
    astar.begin(flight_start(mission_), end(), options_of(kPasses[pass_]));
  }
  const std::uint64_t before = astar.expansions();
  std::uint64_t most = pass_ == 0 ? kSecond : kSlice;
  if (pool_.empty()) most = std::numeric_limits<std::uint64_t>::max();
  const auto track = astar.go_on(most, run_);
  plan.counters["expansions"] += astar.expansions() - before;
  searching_ = !track && !astar.exhausted();
  if (searching_) return;
  if (track) pool_.add_bettered(path_of(*track), random_, run_);
  ++pass_;
}

/// Choosing altitudes takes as long as changing a way. What is flown does not hang on when the run will end, so that
/// more iterations never give a worse route.
bool IntervalRun::is_worth_flying(const Plan& plan) const {
  constexpr double kGain = 0.001;
  constexpr std::uint64_t kFlyEvery = 8;
  if (pool_.empty() || pool_.best().cost() >= flown_) return false;
  const bool much = pool_.best().cost() < (1 - kGain) * flown_;
  return plan.route.empty() || much || run_.iterations() % kFlyEvery == 0;
}

void IntervalRun::improve(ClimbField& to_go, IntervalAStar& astar, Plan& plan,
                          const std::function<void(Plan&)>& note_bound) {
  bool bounded = note_bound == nullptr;
  bool first = true;
  while (run_.start_iteration(kIterations)) {
    if (pool_.empty() && !looked_for_first_) {
      search_first(to_go, astar, plan);
    } else if (pass_ < kPasses.size() && (pool_.empty() || run_.iterations() % 2 == 0)) {
      search_on(to_go, astar, plan);
    } else if (pool_.empty()) {
      return;
    } else {
      pool_.better(random_, run_);
    }
    if (!looked_for_shortest_ && !pool_.empty() && !pool_.best().keeps_range()) search_shortest(plan);
    if (is_worth_flying(plan)) fly_best(plan);
    if (!plan.route.empty()) run_.report(plan.cost);
    if (bounded || (plan.route.empty() && !std::exchange(first, false))) continue;
    note_bound(plan);
    bounded = !plan.route.empty();
    if (plan.outcome == Outcome::infeasible_proven) return;
  }
}

void IntervalRun::fly_best(Plan& plan) {
  const FlightPath& path = pool_.best();
  flown_ = path.cost();
  auto route = fly_track(air_.cost, path.track(), mission_.start, path.end());
  if (!route) return;
  if (!before_.empty()) {
    Route whole = before_;
    whole.states.insert(whole.states.end(), route->states.begin() + 1, route->states.end());
    route = std::move(whole);
  }
  const double cost = air_.objective.route_cost(*route);
  keep_if_better(air_.world.site(), std::move(*route), cost, plan);
}

/// By length alone: where threats ask for a longer way than the range allows.
void IntervalRun::search_shortest(Plan& plan) {
  looked_for_shortest_ = true;
  Site site = air_.world.site();
  site.scenario.objective.threat = 0;
  site.scenario.objective.climb = 0;
  const FlightAir air(World(std::move(site)));
  const ClimbField to_go(air.world, air.band.slopes(), run_);
  IntervalAStar astar(air.cost, to_go);
  const auto track = astar.find(flight_start(mission_), end(), options_of(kHasty), run_);
  plan.counters["expansions"] += astar.expansions();
  if (track) pool_.add_bettered(path_of(*track), random_, run_);
}

}  // namespace alate
