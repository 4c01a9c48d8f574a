// How the navigation errors of a route grow and are corrected, for the rules and for the chance of success.
#pragma once

#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// A state of the route that bears the id of a correction point.
struct Visit {
  std::size_t state = 0;
  const CorrectionPoint* point = nullptr;
  bool unknown = false;  ///< The state names a point that does not exist.
  double length_m = 0;   ///< Flown since the visit before, or since the start.
};

/// All visits in order; the last is the last state, whether a point or not. The start and the goal under their own ids
/// are no visits. Empty without states.
std::vector<Visit> visits_of(const Navigation& navigation, const Route& route);

struct Errors {
  double vertical = 0;
  double horizontal = 0;

  auto operator<=>(const Errors&) const = default;
};

Errors grown(const Navigation& navigation, const Errors& errors, double length_m);

/// What is left after the point's correction has worked, or failed: then min(error, residual) of what it resets.
Errors corrected(const Errors& errors, PointKind kind);
Errors uncorrected(const Navigation& navigation, const Errors& errors, PointKind kind);

/// Limits on arrival at a point of this kind.
const Navigation::Limits& limits_at(const Navigation& navigation, PointKind kind);

}  // namespace alate
