// A finished run as other programs read it, and the files it is written to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/check/check.hpp"
#include "alate/plan/planner.hpp"
#include "alate/plan/registry.hpp"

namespace alate {

/// All that is known about one run. Borrowed parts must outlive it.
struct Result {
  const Site& site;
  const ChosenPlanner& planner;
  Plan plan;
  Metrics metrics;
  Verdict verdict;
  double wall_s = 0;  ///< Planning alone.
  int threads = 1;
  std::vector<std::string> files;  ///< Names inside the output folder, once written.
  std::vector<std::string> warnings;
};

/// (cost - lower_bound) / lower_bound, nothing where the bound is not positive or there is no route.
std::optional<double> gap(const Result& result);

/// One or two plain sentences: was a route found, is it allowed, how far from the best can it be.
std::string summary(const Result& result);

/// result.json as in the contracts.
std::string to_json(const Result& result);
/// {"schema": 1, "errors": [...]} for bad input.
std::string to_json(const std::vector<Fault>& faults);
/// The verdict and metrics of `alate check --json`.
std::string to_json(const Site& site, const Verdict& verdict, const Metrics& metrics);

/// Writes result.json, report.html and, with a route, route.csv, .geojson, .kml, .plan and .waypoints into
/// `folder` (made if missing). Every file is written aside and renamed; nothing else in the folder is touched.
/// A local frame leaves out the files that need a place on Earth, a route that did not pass the check those that an
/// autopilot would fly; `warnings` says so. Fills `files`. A route file of an earlier run that is not written again is
/// removed. Throws InputError if the folder cannot be written or another run holds it, std::system_error if the disk
/// fails.
void write_results(const std::string& folder, Result& result);

}  // namespace alate
