// The second witness: is this route what the scenario asked for? It knows nothing of World, spaces or planners.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// The only slack of every rule: a margin down to minus this is rounding noise (metres, or degrees).
inline constexpr double kRoundingNoise = 1e-6;

/// One broken rule on one leg. `leg` is the index of the state that ends it; 0 is the start.
struct Violation {
  std::string rule;
  std::size_t leg = 0;
  Vec3 where;
  double value = 0;
  double limit = 0;
  std::string unit;
};

/// How far the route stays from breaking a rule, at its worst place; negative: broken.
struct Margin {
  std::string rule;
  double margin = 0;
  std::string unit;
  std::size_t leg = 0;
  Vec3 where;
};

/// A rule that could not be judged. `unknown` says that data were given but do not reach (voids).
struct NotChecked {
  std::string rule;
  std::string why;
  bool unknown = false;
};

enum class Status { pass, fail, unknown };

const char* to_string(Status status);

struct Verdict {
  Status status = Status::pass;
  std::vector<Violation> violations;
  std::vector<Margin> margins;  ///< One per judged rule, in the order of the contracts.
  std::vector<NotChecked> not_checked;

  bool ok() const { return status == Status::pass; }
};

/// Sizes of a route, whether it is allowed or not.
struct Metrics {
  double cost = 0;  ///< By the scenario's objective.
  double length_m = 0;
  double climb_m = 0;
  double descent_m = 0;
  double threat = 0;                      ///< Exposure: metres in the physical model, sum over nodes in konatowski2019.
  std::optional<double> min_clearance_m;  ///< Nothing without ground, or where it is unknown.
  std::optional<std::size_t> corrections;  ///< Correction points used; nothing without navigation errors.
  std::optional<double> probability;       ///< That no error breaks its limit although points fail; as above.
  std::optional<GridMeasures> grid;        ///< Nothing without a grid.
};

/// Computes cost and sizes from the scenario's own data, by closed forms on straight legs and to 1e-6 (relative)
/// on arcs. An empty route measures zero, and so does one with positions that are not numbers.
Metrics measure(const Site& site, const Route& route);

/// Judges every leg, whole, by every rule for which data were given. Nothing is granted but kRoundingNoise.
/// Positions that are not numbers, or no place on Earth, break `bounds`, and nothing else is judged then; a route
/// without states breaks `arrival`. Values are finite: "no turn at all" has a radius of 1e9 m.
Verdict check(const Site& site, const Route& route);

}  // namespace alate
