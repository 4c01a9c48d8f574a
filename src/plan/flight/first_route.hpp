// The first route after a change in flight: as much as possible of what is known already.
#pragma once

#include <optional>
#include <span>

#include "alate/core/along_route.hpp"
#include "plan/flight/interval_run.hpp"

namespace alate {

/// What a flight was planned with, in a world that may have changed since.
struct KnownFlight {
  const FlightAir& air;
  IntervalAStar& astar;
  ClimbField& field;              ///< Of this world, grown or not; or of the one before, where `field_is_old`.
  bool field_is_old = false;      ///< Still a guide, but to other ceilings or threats.
  std::span<const Threat> added;  ///< Threats that the world before had not, and `field` knows of.
  Route rest;                     ///< Of the old route, from the start of the site's mission.
};

/// Tries in turn: the rest as it is; the rest left for a moved goal; from a place on the rest shortly before a new
/// threat to the goal, guided by a field that is worked out round the threat alone; from the place on the rest nearest
/// to the goal; from the state in flight. A field of every altitude near floor or ceiling counts a bit too high and
/// low, so a flight that hugs them goes on along its old route until it has room. Where nothing is found `plan` stays
/// as it is.
void find_first_route(const KnownFlight& known, RunContext& run, Plan& plan);

/// A run that starts from the route of `plan`, which begins at the site's start, and keeps as little of its beginning
/// as room to turn takes; from the start where there is no route.
IntervalRun run_from(const FlightAir& air, const Plan& plan, RunContext& run);

}  // namespace alate
