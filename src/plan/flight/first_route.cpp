#include "plan/flight/first_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "search/interval/track_of.hpp"
#include "space/dubins/dubins_point.hpp"

namespace alate {

namespace {

/// Metres of the old route that are flown before the first change, each tried where the one before leaves no room.
constexpr std::array kLeads_m{0.0, 25.0, 50.0, 100.0, 200.0};
/// Radii between a place where a search begins and what it is to get round.
constexpr double kRoom = 10;
/// Nodes of a search by a field of another world, which may be led into a trap.
constexpr std::uint64_t kMostMisled = 20'000;

Mission mission_from(const FlightAir& air, const FlightState& state) {
  Mission mission = air.world.site().mission;
  mission.start = state.position;
  mission.heading_rad = state.heading_rad;
  mission.heading_given = true;
  return mission;
}

/// A run from a place on a route, which is flown as it is up to there.
std::optional<IntervalRun> run_after(const FlightAir& air, const Route& route, double lead_m, RunContext& run) {
  if (lead_m <= 0) return IntervalRun(air, air.world.site().mission, run);
  const auto state = state_along(route, lead_m);
  if (!state) return std::nullopt;
  return IntervalRun(air, mission_from(air, *state), run, begin_of(route, lead_m));
}

Track cut(const Track& track, double spacing_m) {
  Track parts;
  for (const PlanarPiece& piece : track) {
    const int count = std::max(1, static_cast<int>(std::ceil(piece.length_m / spacing_m)));
    for (int k = 0; k < count; ++k) {
      PlanarPiece part = piece;
      part.start = piece.at(piece.length_m * k / count);
      part.length_m = piece.length_m / count;
      parts.push_back(part);
    }
  }
  return parts;
}

/// The shortest of the tracks that leave an old one somewhere for the end.
Track left_for(const FlightEnd& end, const Track& old, const BandWalk& band, double z) {
  constexpr double kPlaces = 100;
  const Track parts = cut(old, std::max(length_of(old) / kPlaces, band.radius_m()));
  AltitudeLabel label = AltitudeLabel::at(z);
  Track best;
  double shortest = std::numeric_limits<double>::infinity();
  double flown = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Track last;
    append(last, shortest_dubins_to_point(parts[k].start, end.place(), band.radius_m()));
    cut_at_end(last, end);
    const double length = flown + length_of(last);
    AltitudeLabel there = label;
    const bool lives = length < shortest &&
                       std::ranges::all_of(
                           last, [&](const PlanarPiece& piece) { return band.advance(piece, there); }) &&
                       there.low <= end.high() && there.high >= end.low();
    if (lives) {
      shortest = length;
      best.assign(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(k));
      best.insert(best.end(), last.begin(), last.end());
    }
    if (!band.advance(parts[k], label)) break;
    flown += parts[k].length_m;
  }
  return best;
}

class FirstRoute {
 public:
  FirstRoute(const KnownFlight& known, RunContext& run, Plan& plan)
      : known_(known), run_(run), plan_(plan), length_m_(flown_length(known.rest)) {}

  void find() {
    if (!known_.rest.empty() && (follow() || leave_for_goal() || round_threat() || join_goal())) return;
    search_whole();
  }

 private:
  double radius() const { return known_.air.band.radius_m(); }

  bool take(IntervalRun& flight, bool found) {
    if (found) flight.fly_best(plan_);
    return found && !plan_.route.empty();
  }

  bool follow() {
    return std::ranges::any_of(kLeads_m, [&](double lead_m) {
      auto flight = run_after(known_.air, known_.rest, lead_m, run_);
      return flight && take(*flight, flight->add(track_of(rest_of(known_.rest, lead_m), radius())));
    });
  }

  bool leave_for_goal() {
    IntervalRun flight(known_.air, known_.air.world.site().mission, run_);
    const double z = known_.air.world.site().mission.start.z();
    return take(flight, flight.add(left_for(flight.end(), track_of(known_.rest, radius()), known_.air.band, z)));
  }

  bool search_after(double lead_m, ClimbField& field) {
    auto flight = run_after(known_.air, known_.rest, lead_m, run_);
    if (!flight) return false;
    known_.astar.turn_to(known_.air.cost, field);
    IntervalPass pass = IntervalRun::kHasty;
    if (known_.field_is_old) pass.most_nodes = kMostMisled;
    return take(*flight, flight->search(known_.astar, pass, plan_));
  }

  struct Nearest {
    double flown_m = 0;
    double distance_m = std::numeric_limits<double>::infinity();
  };
  /// Where the rest first comes within `reach_m` of a place; or else, nearest to it.
  Nearest nearest_to(const Vec2& place, double reach_m) const {
    Nearest nearest;
    for (double at = 0; at < length_m_ && nearest.distance_m > reach_m; at += radius()) {
      const auto state = state_along(known_.rest, at);
      const double distance = state ? (state->position.head<2>() - place).norm() : nearest.distance_m;
      if (distance < nearest.distance_m) nearest = {at, distance};
    }
    return nearest;
  }

  /// The first of the new threats that is met; a flight far ahead of the others is left to a whole search.
  bool round_threat() {
    if (known_.field_is_old) return false;
    Nearest first;
    const Threat* met = nullptr;
    for (const Threat& threat : known_.added) {
      const Vec2 center = threat.center.head<2>();
      if (threat.core_m <= 0 || nearest_to(center, threat.core_m).distance_m > threat.core_m) continue;
      const Nearest before = nearest_to(center, 1.5 * threat.core_m + kRoom * radius());
      if (met == nullptr || before.flown_m < first.flown_m) {
        first = before;
        met = &threat;
      }
    }
    if (met == nullptr) return false;
    ClimbField local(known_.field);
    const double around = std::max(first.distance_m, 1.6 * met->core_m) + kRoom * radius();
    local.confine(met->center.head<2>(), around);
    return grow_and_search(first.flown_m, local);
  }

  bool join_goal() {
    if (known_.field_is_old || !known_.added.empty()) return false;
    const Vec2 goal = known_.air.world.site().mission.goal.head<2>();
    const Nearest nearest = nearest_to(goal, 0);
    return grow_and_search(std::max(0.0, nearest.flown_m - kRoom * radius()), known_.field);
  }

  bool grow_and_search(double lead_m, ClimbField& field) {
    const auto state = state_along(known_.rest, lead_m);
    if (!state) return false;
    field.grow(run_, state->position);
    return search_after(lead_m, field);
  }

  void search_whole() {
    if (!known_.field_is_old) known_.field.grow(run_, known_.air.world.site().mission.start);
    std::ranges::any_of(kLeads_m, [&](double lead_m) { return search_after(lead_m, known_.field); });
  }

  const KnownFlight& known_;
  RunContext& run_;
  Plan& plan_;
  double length_m_;
};

}  // namespace

void find_first_route(const KnownFlight& known, RunContext& run, Plan& plan) { FirstRoute(known, run, plan).find(); }

IntervalRun run_from(const FlightAir& air, const Plan& plan, RunContext& run) {
  for (const double lead_m : kLeads_m) {
    auto flight = run_after(air, plan.route, lead_m, run);
    if (flight && flight->add(track_of(rest_of(plan.route, lead_m), air.band.radius_m()))) return std::move(*flight);
  }
  return {air, air.world.site().mission, run};
}

}  // namespace alate
