// A planner on grids or voxels on the tasks of the Moving AI path-finding benchmarks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "alate/core/run_context.hpp"
#include "alate/plan/registry.hpp"

namespace alate {

struct ScenOptions {
  PlannerRequest request;
  std::optional<std::uint64_t> rows;  ///< Those with the longest optimum; none: all.
  std::stop_token stop;
  std::function<void(const Progress&)> on_progress;  ///< An iteration is a row.
};

/// Sums over rows. Lengths are what `measure` says of routes that passed `check`.
struct ScenSummary {
  std::string planner;
  std::string preset;
  std::string why;                 ///< Why this planner.
  std::size_t rows = 0;            ///< That were run.
  std::size_t solved = 0;          ///< With a route that passed the check.
  std::size_t optimal = 0;         ///< As long as published: within 1e-3 cells, or half a unit of the sixth digit.
  std::size_t shorter = 0;         ///< Shorter than published, as any-angle routes may be.
  std::optional<double> mean_gap;  ///< (length - published) / published, of solved rows.
  std::optional<double> mean_s;    ///< Planning alone, one thread.
  std::optional<double> p99_s;     ///< 99 of 100 rows took no longer.
  bool stopped = false;
};

/// Reads a `.map.scen` file with its map (Sturtevant 2012), or a `.3dmap.3dscen` file with its voxels (Brewer and
/// Sturtevant 2018), and plans row by row. What is timed is Planner::plan from
/// the ends of a row to its route, with lower bound; not reading, not the check, and not what a planner prepares once
/// for a map, which a first run that is stopped at once has done. Throws InputError with every fault of the file, or
/// for a planner that does not exist or cannot serve.
ScenSummary run_scen(const std::string& file, const ScenOptions& options);

/// What a terminal shows.
std::string to_text(const ScenSummary& summary);

/// {"rows", "solved", "optimal", "mean_gap", "mean_s", "p99_s", ...}
std::string to_json(const ScenSummary& summary);

}  // namespace alate
