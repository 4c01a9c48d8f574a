#include "plan/interval_run.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "plan/flight_ends.hpp"
#include "search/interval/flight_profile.hpp"

namespace alate {

namespace {

/// One search each, the hasty one first.
constexpr std::array kPasses{IntervalRun::kHasty,     IntervalPass{1.15, 1},   IntervalPass{1.05, 1},
                             IntervalPass{1.15, 0.5}, IntervalPass{1.05, 0.5}, IntervalPass{1.15, 2},
                             IntervalPass{1.05, 2}};

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
    : air_(air), mission_(std::move(mission)), run_(run), before_(std::move(before)), random_(run.seed(), 0, 0) {}

FlightEnd IntervalRun::end() const { return flight_end(mission_.goal, mission_.tolerance_m); }

bool IntervalRun::add(const Track& track) {
  if (track.empty()) return false;
  const Vec2 last = track.back().end().position();
  const FlightEnd end = end_at(this->end(), last);
  constexpr double kRounding_m = 1e-6;
  if ((last - end.place()).norm() > end.tolerance_m + kRounding_m) return false;
  FlightPath path(air_.cost, end, track, mission_.start.z());
  if (!std::isfinite(path.cost())) return false;
  paths_.push_back(std::move(path));
  std::ranges::stable_sort(paths_, std::less{}, &FlightPath::cost);
  in_flight_ = true;
  pass_ = std::max<std::size_t>(pass_, 1);  // Haste is for those who have nothing.
  return true;
}

bool IntervalRun::search(IntervalAStar& astar, const IntervalPass& pass, Plan& plan) {
  const double bin = bin_width((mission_.goal - mission_.start).norm(), air_.band.radius_m());
  const auto track =
      astar.find(flight_start(mission_), end(),
                 {.epsilon = pass.epsilon, .bin_m = bin * pass.bin, .most_nodes = pass.most_nodes}, run_);
  plan.counters["expansions"] += astar.expansions();
  if (!track) return false;
  paths_.emplace_back(air_.cost, end(), *track, mission_.start.z());
  paths_.back().shorten(run_);
  return true;
}

void IntervalRun::search_next(IntervalAStar& astar, Plan& plan) {
  constexpr std::uint64_t kMostInFlight = 50'000;  // nodes, some 0.1 s
  IntervalPass pass = kPasses[pass_++];
  if (in_flight_) pass.most_nodes = kMostInFlight;
  if (search(astar, pass, plan)) paths_.back().better(random_, kTrials, run_);
}

void IntervalRun::change_some() {
  // The best one every other round, the second one every fourth, ...
  const auto rank = static_cast<std::size_t>(std::countr_zero(++rounds_));
  paths_[std::min(rank, paths_.size() - 1)].better(random_, kTrials, run_);
}

void IntervalRun::improve(IntervalAStar& astar, Plan& plan, const std::function<void(Plan&)>& note_bound) {
  bool bounded = note_bound == nullptr;
  while (run_.start_iteration(kIterations)) {
    if (pass_ < kPasses.size() && (!in_flight_ || run_.iterations() % 2 != 0)) {
      search_next(astar, plan);
    } else if (paths_.empty()) {
      return;
    } else {
      change_some();
    }
    std::ranges::stable_sort(paths_, std::less{}, &FlightPath::cost);
    if (!paths_.empty()) fly_best(plan);
    if (bounded || (plan.route.empty() && run_.iterations() > 1)) continue;
    note_bound(plan);
    bounded = !plan.route.empty();
    if (plan.outcome == Outcome::infeasible_proven) return;
  }
}

void IntervalRun::fly_best(Plan& plan) {
  const FlightPath& path = paths_.front();
  auto route = fly_track(air_.cost, path.track(), mission_.start, path.end());
  if (!route) return;
  if (!before_.empty()) {
    Route whole = before_;
    whole.states.insert(whole.states.end(), route->states.begin() + 1, route->states.end());
    route = std::move(whole);
  }
  const double cost = air_.objective.route_cost(*route);
  if (plan.route.empty() || cost < plan.cost) {
    plan.outcome = Outcome::feasible;
    plan.route = std::move(*route);
    plan.cost = cost;
  }
  run_.report(plan.cost);
}

}  // namespace alate
