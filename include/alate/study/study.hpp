// Studies: planners tried on scenarios over seeds and budgets, every run written down as it ends.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "alate/core/executor.hpp"
#include "alate/core/run_context.hpp"
#include "alate/plan/registry.hpp"
#include "alate/world/world.hpp"

namespace alate {

/// What one run may use; neither: the planner's own default.
struct StudyBudget {
  std::optional<std::uint64_t> iterations;
  std::optional<double> time_s;

  /// "iterations=100", "time_s=0.1", "default".
  std::string text() const;
};

struct StudyScenario {
  std::string name;
  World world;
  std::size_t group = 0;  ///< Of the study's groups.
};

/// A planner ready to run.
struct StudyPlanner {
  std::string name;
  std::string preset;  ///< With the parameters that were set: "guided ants=20".
  /// On a scenario's site; a proof of an exact planner holds for planners of the same space.
  std::function<Abilities(const Site&)> can_on;
  bool chance = true;  ///< The seed changes its runs.
  Planner planner;
};

/// One run.
struct StudyJob {
  std::size_t scenario = 0;
  std::size_t planner = 0;  ///< Of `planners`, or of `references`.
  std::size_t budget = 0;
  std::uint64_t seed = kDefaultSeed;
  bool reference = false;  ///< An exact planner without a budget, for the optimum.
};

/// A planner that cannot serve the scenarios of a group, and the first of its reasons.
struct StudyRefusal {
  std::size_t group = 0;
  std::size_t planner = 0;
  std::string why;
};

struct Study {
  std::string file;
  std::vector<std::string> groups;  ///< Names; one, empty, where the file makes no groups.
  std::vector<StudyScenario> scenarios;
  std::vector<StudyPlanner> planners;
  std::vector<StudyPlanner> references;
  std::vector<StudyBudget> budgets;
  std::vector<StudyRefusal> refusals;  ///< By group, then planner: pairs without jobs.
  std::vector<StudyJob> jobs;          ///< By scenario, planner, budget, seed; then the references.
  std::string fingerprint;  ///< Of the study's text, its scenarios, what they name, the version: whose journal it is.
};

/// What is kept of one run. Costs are what `measure` says.
struct StudyRecord {
  Outcome outcome = Outcome::none_found;
  bool valid = false;  ///< There is a route and `check` passes it.
  double cost = 0;     ///< These mean nothing without a route.
  double length_m = 0;
  std::optional<GridMeasures> grid;
  double lower_bound = 0;
  double wall_s = 0;
  std::uint64_t iterations = 0;                                ///< 0: not told.
  std::vector<std::pair<std::uint64_t, double>> improvements;  ///< Iteration, from 1, and best cost so far from there.

  bool has_route() const { return outcome == Outcome::optimal || outcome == Outcome::feasible; }
};

/// By job; nothing where none has run.
using StudyRecords = std::vector<std::optional<StudyRecord>>;

/// Reads a study file; "-" is standard input. Paths are relative to it. Throws InputError with every fault of the
/// study and of its scenarios: those of a scenario file, unknown planners, presets and parameters, planners that serve
/// some scenarios of a group but not all, or no group; counts beyond the limits. See docs/studies.md.
Study load_study(const std::string& file, const Registry& registry = builtin_planners());

struct StudyOptions {
  std::string folder;    ///< Of the journal; empty: none is kept.
  std::size_t rank = 0;  ///< Of this process among them; names its journal.
  /// Hands out 0, 1, 2, ... to all processes that share the runs, each number to one of them, until long after the last
  /// run. Any thread may call it. Empty: one process does them all.
  std::function<std::size_t()> next;
  std::stop_token stop;
  std::function<void(const Progress&)> on_progress;  ///< Called by one thread at a time; an iteration is a run.
};

/// The runs that the journals of `folder` hold. A line that was torn when its process died is left out. Throws
/// InputError (field `--out`) if a journal belongs to another study.
StudyRecords read_journals(const Study& study, const std::string& folder);

/// Does what `records` lacks, or those of it that `next` hands out, one run a thread, and adds each to its journal as
/// it ends. False if stopped. Throws std::system_error if the disk fails.
bool run_study(const Study& study, StudyRecords& records, Executor& executor, const StudyOptions& options);

/// One line a run, in the order of the jobs, references left out; then one for each scenario that a planner refused.
/// The same at any number of threads, ranks and interruptions, under budgets of iterations.
std::string rows_csv(const Study& study, const StudyRecords& records);

/// Planning time of the same runs.
std::string times_csv(const Study& study, const StudyRecords& records);

/// The comparison in plain words for a terminal, and as a page of its own, group by group.
std::string to_text(const Study& study, const StudyRecords& records);
std::string study_html(const Study& study, const StudyRecords& records);

/// Tables in Markdown, one a group: for every planner and budget the share of valid routes, the median cost above the
/// best known, and the planning time of the least budget whose median run comes within 1 % of it.
std::string summary_markdown(const Study& study, const StudyRecords& records);

class OutputFolder;

/// A folder that one study writes into. A lock that a dead process left does not count.
class StudyFolder {
 public:
  /// Makes and locks the folder. Throws InputError (field `--out`) if it cannot be made or another run holds it.
  explicit StudyFolder(const std::string& folder);
  ~StudyFolder();
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;

  /// Writes study.html, summary.md, rows.csv and times.csv, and returns their names. Files are written aside and
  /// renamed.
  std::vector<std::string> write(const Study& study, const StudyRecords& records);

 private:
  std::unique_ptr<OutputFolder> output_;
};

}  // namespace alate
