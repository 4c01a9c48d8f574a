// One flight, planned and planned again while it is flown: what was built for the last plan serves the next.
//
//   Session session(load_site(load_scenario("scenario.yaml")));
//   Plan plan = session.plan(run);
//   const FlightState now = *state_along(plan.route, 4200);             // 4.2 km flown
//   Plan next = session.replan(now, {.threats = all_known_now}, run2);  // a way round, within milliseconds
//   check(session.site(), next.route);
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "alate/core/along_route.hpp"
#include "alate/world/problem.hpp"

namespace alate {

/// What has changed since the last plan; what is not given stays as it was.
struct FlightChange {
  std::optional<std::vector<Threat>> threats;  ///< All there are from now on.
  std::optional<Vec3> goal;
  std::optional<double> tolerance_m;
  std::optional<Band> band;  ///< Clearance and ceilings.
};

/// Plans as `interval-astar` does. Keeps the cost-to-go, as far as it still holds, the arrays of the search and the
/// route. Not for two threads at once; moved, not copied.
///
/// A replan looks first at what is left of the old route. If that keeps the new limits it is the first answer;
/// otherwise a small field round the new threat, or from the new goal to the old route, guides a search that joins what
/// can be kept. All this is the first iteration of `run`; the others search anew from the state in flight and change
/// what was found, as far as iterations and time limit reach. The same calls with the same budgets of iterations give
/// the same bits.
class Session {
 public:
  /// Throws InputError where interval-astar cannot serve the site (see `alate planners`).
  explicit Session(Site site);
  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;
  ~Session();

  /// What the last plan was made for, its start where that began: what `check` and `measure` judge by. Holds until the
  /// next replan.
  const Site& site() const;
  /// The route that is flown: of the last plan that found one, or given to `follow`. Empty before.
  const Route& route() const;

  /// From the start of the site.
  Plan plan(RunContext& run);

  /// The aircraft flies this route, which begins at the start of the site; for routes that were planned elsewhere.
  void follow(Route route);

  /// From a state in flight, usually `state_along` the route; an aircraft that has drifted off it is led back. The
  /// route found begins at the state. If none is found the plan says why, the old route is kept and the site is the
  /// changed one. `flown_m` beyond the route counts as its end. `range_m` of the site's vehicle is what is left from
  /// the state on, which the caller knows. All numbers must be finite.
  Plan replan(const FlightState& state, const FlightChange& change, RunContext& run);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace alate
