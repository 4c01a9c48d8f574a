#include "alate/plan/session.hpp"

#include <algorithm>

#include "alate/core/fault.hpp"
#include "plan/flight/first_route.hpp"
#include "plan/flight/flight_bound.hpp"
#include "plan/flight/flight_plan.hpp"
#include "plan/flight/flight_planners.hpp"

namespace alate {

namespace {

bool same(const Threat& a, const Threat& b) {
  return a.shape == b.shape && a.center == b.center && a.radius_m == b.radius_m && a.level == b.level &&
         a.core_m == b.core_m && a.floor_m == b.floor_m && a.top_m == b.top_m;
}

bool same(const Band& a, const Band& b) {
  return a.clearance_m == b.clearance_m && a.ceiling_agl_m == b.ceiling_agl_m && a.ceiling_amsl_m == b.ceiling_amsl_m;
}

/// The threats beyond those of before; nothing where some of those are gone or others.
std::optional<std::span<const Threat>> added(const std::vector<Threat>& before, const std::vector<Threat>& now) {
  const std::span all(now);
  const auto alike = [](const Threat& a, const Threat& b) { return same(a, b); };
  if (now.size() < before.size() || !std::ranges::equal(before, all.first(before.size()), alike)) return std::nullopt;
  return all.subspan(before.size());
}

Site changed(Site site, const FlightState& state, const FlightChange& change) {
  Mission& mission = site.mission;
  mission.start = state.position;
  mission.heading_rad = state.heading_rad;
  mission.heading_given = true;
  mission.goal = change.goal.value_or(mission.goal);
  mission.tolerance_m = change.tolerance_m.value_or(mission.tolerance_m);
  if (change.threats) site.threats = *change.threats;
  if (change.band) site.band = *change.band;
  return site;
}

/// Nothing where the aircraft is not on the route.
Route rest_for(const Route& route, const FlightState& state) {
  constexpr double kOnRoute_m = 1e-3;
  constexpr double kOnRoute_rad = 1e-4;
  const auto there = state_along(route, state.flown_m);
  if (!there || (there->position - state.position).norm() > kOnRoute_m ||
      turn_between(direction_of(there->heading_rad), direction_of(state.heading_rad)) > kOnRoute_rad)
    return {};
  return rest_of(route, state.flown_m);
}

}  // namespace

struct Session::Kept {
  explicit Kept(Site site) : air(std::make_unique<FlightAir>(World(std::move(site)))) {}

  const Site& site() const { return air->world.site(); }

  std::function<void(Plan&)> bound_by(RunContext& run) const {
    return [this, &run](Plan& plan) { note_bound(Problem(air->world), BoundEffort::quick, run, plan); };
  }

  /// A field of this world, as far as it has grown. It starts where there is none, at the goal.
  ClimbField& any_field(RunContext& run) {
    if (!field) {
      field.emplace(air->world, air->band.slopes(), run, site().mission.goal);
      field_is_cut = !run.keep_going();
    }
    if (!astar) astar.emplace(air->cost, *field);
    return *field;
  }

  /// Everywhere, and of this world.
  void complete_field(RunContext& run) {
    if (field_is_old) field.reset();
    field_is_old = false;
    any_field(run).grow(run);
    astar->turn_to(air->cost, *field);
  }

  void keep(const Plan& plan) {
    if (field_is_cut) field.reset();
    if (!plan.route.empty()) route = plan.route;
  }

  /// What of the threats is new to the field, once it is that of the changed world.
  std::span<const Threat> turn_to(std::unique_ptr<FlightAir> next) {
    const Site& before = air->world.site();
    const Site& now = next->world.site();
    const auto more = added(before.threats, now.threats);
    const bool goal_moved =
        before.mission.goal != now.mission.goal || before.mission.tolerance_m != now.mission.tolerance_m;
    const bool other_space = !more || !same(before.band, now.band);
    // Without ground the field reaches as far as start, goal and threats.
    const bool other_extent = !now.has_ground() && (goal_moved || !more->empty());
    field_is_old = field_is_old || other_space || other_extent;
    std::span<const Threat> news;
    if (field) {
      news = field_is_old ? std::span<const Threat>{} : *more;
      field->add_threats(next->world, news);
      if (goal_moved) field->aim_anew();
    }
    air = std::move(next);
    return news;
  }

  std::unique_ptr<FlightAir> air;
  std::optional<ClimbField> field;
  bool field_is_old = false;  ///< Of other ceilings or threats than those of `air`.
  bool field_is_cut = false;  ///< The run ended before all cells were looked at.
  std::optional<IntervalAStar> astar;
  Route route;
};

Session::Session(Site site) : kept_(std::make_unique<Kept>(std::move(site))) {
  const std::string refusal = interval_astar_entry().refuses(Problem(kept_->air->world));
  if (!refusal.empty())
    throw InputError(
        Fault{.file = this->site().scenario.file, .message = "interval-astar cannot plan this: it " + refusal});
}

Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

const Site& Session::site() const { return kept_->site(); }
const Route& Session::route() const { return kept_->route; }
void Session::follow(Route route) { kept_->route = std::move(route); }

Plan Session::plan(RunContext& run) {
  Plan plan = plan_flight(Problem(kept_->air->world), run, kNoFlight, [&](Plan& so_far) {
    kept_->complete_field(run);
    IntervalRun(*kept_->air, site().mission, run).improve(*kept_->field, *kept_->astar, so_far, kept_->bound_by(run));
  });
  kept_->keep(plan);
  return plan;
}

Plan Session::replan(const FlightState& state, const FlightChange& change, RunContext& run) {
  Kept& kept = *kept_;
  const auto news = kept.turn_to(std::make_unique<FlightAir>(World(changed(site(), state, change))));
  Plan plan = begin_flight(site(), run);
  if (plan.route.empty() && run.start_iteration(IntervalRun::kIterations)) {
    ClimbField& field = kept.any_field(run);
    find_first_route({.air = *kept.air,
                      .astar = *kept.astar,
                      .field = field,
                      .field_is_old = kept.field_is_old,
                      .added = news,
                      .rest = rest_for(kept.route, state)},
                     run, plan);
    if (plan.route.empty()) note_barrier(Problem(kept.air->world), run, plan);
    const bool is_over = plan.outcome == Outcome::infeasible_proven;
    const bool may_go_on = run.iterations() < run.iteration_limit() || run.iteration_limit() == 0;
    if (!is_over && (may_go_on || plan.route.empty())) {
      kept.complete_field(run);
      IntervalRun flight = run_from(*kept.air, plan, run);
      if (plan.route.empty() && flight.search_first(*kept.field, *kept.astar, plan)) flight.fly_best(plan);
      if (may_go_on) flight.improve(*kept.field, *kept.astar, plan, kept.bound_by(run));
    }
  }
  conclude_flight(plan, run, kNoFlight);
  kept.keep(plan);
  return plan;
}

}  // namespace alate
