// Published results put to the test: each claim beside our own figures, with a verdict and its reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "alate/core/executor.hpp"
#include "alate/core/param_table.hpp"
#include "alate/core/run_context.hpp"

namespace alate {

enum class ClaimVerdict { holds, does_not_hold, impossible, cannot_be_told };

/// "holds", "does_not_hold", "impossible", "cannot_be_told".
const char* to_string(ClaimVerdict verdict);

/// One thing that a paper says.
struct Claim {
  std::string id;
  std::string text;
  std::optional<double> published;  ///< Nothing where the claim is not a number.
  std::optional<double> ours;       ///< Of several cases: their mean.
  std::string unit;                 ///< Empty for a pure number.
  ClaimVerdict verdict = ClaimVerdict::cannot_be_told;
  std::string why;                                      ///< Plain sentences.
  std::vector<std::pair<std::string, double>> by_case;  ///< What `ours` is made of.
};

/// All runs of one method on one case. Costs are what `measure` says, of routes that passed `check`.
struct Cell {
  std::string case_name;
  std::string method;
  std::size_t runs = 0;
  std::size_t found = 0;       ///< Runs that ended with a route that passed the check.
  std::optional<double> mean;  ///< Nothing where none did.
  std::optional<double> sd;    ///< Of the sample (n - 1); nothing below two routes.
  std::optional<double> best;
  std::optional<double> worst;
  double lower_bound = 0;  ///< No route of the case costs less.
  double wall_s = 0;       ///< Mean of planning alone, one thread a run.
};

/// Something wrong with what was published, in plain words, with a figure of ours that shows it.
struct Defect {
  std::string title;
  std::string text;
  std::string measured;
};

struct Reproduction {
  std::string paper;
  std::string title;
  std::vector<std::string> notes;  ///< What must be known before any figure is read, in plain sentences.
  std::vector<Claim> claims;
  std::vector<Cell> cells;
  std::vector<Cell> details;  ///< Single cases where `cells` sum up several, or other measures; in JSON only.
  std::vector<Defect> defects;
  std::vector<std::pair<std::string, ParamValue>> settings;  ///< All that is needed to do it again.
  std::string page;                                          ///< reproduce.html, whole.
};

struct ReproduceOptions {
  std::optional<std::uint64_t> seeds;       ///< >= 1; seeds 1 to this; none: as the paper's study asks. Planners
                                            ///< without chance run once.
  std::optional<std::uint64_t> iterations;  ///< Of colonies; none: as published.
  std::string data;                         ///< Folder of published data that alate does not ship.
  std::stop_token stop;
  std::function<void(const Progress&)> on_progress;  ///< Called by one thread at a time; an iteration is a run.
};

/// Papers that can be reproduced.
std::vector<std::string> reproducible_papers();

/// Throws InputError, naming the nearest, for a paper that cannot be reproduced.
void require_reproducible(const std::string& paper);

/// Runs the whole comparison, one run a thread. The same at any number of threads but for times. Nothing if it was
/// stopped. Throws InputError for an unknown paper.
std::optional<Reproduction> reproduce(const std::string& paper, Executor& executor, const ReproduceOptions& options);

/// What a terminal shows.
std::string to_text(const Reproduction& reproduction);

/// As in the contracts, with `notes`, `details` and `defects` beside.
std::string to_json(const Reproduction& reproduction);

/// Writes reproduce.html and reproduce.json into `folder` and returns their names. Files are written aside and
/// renamed. Throws as write_results does.
std::vector<std::string> write_reproduction(const std::string& folder, const Reproduction& reproduction);

}  // namespace alate
