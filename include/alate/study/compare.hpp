// Planners side by side on one scenario, at equal wall time: ours, and those of other programs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "alate/check/check.hpp"
#include "alate/core/run_context.hpp"
#include "alate/plan/registry.hpp"
#include "alate/world/world.hpp"

namespace alate {

/// One that takes part. Ours run with their default preset, or the one that the scenario names.
struct Contender {
  std::string name;
  std::string preset;  ///< Empty for a peer.
  std::string help;
  bool peer = false;   ///< Of another program, run as its child.
  bool chance = true;  ///< The seed changes its runs; one without chance runs once.
};

/// How a run stood when a time was up.
enum class Standing {
  passed,   ///< It had a route that passes the check.
  refused,  ///< It had routes, and the check refuses each of them.
  late,     ///< Its route came after the time, and its grace, were over.
  none      ///< It had no route.
};

const char* to_string(Standing standing);

struct CompareMark {
  Standing standing = Standing::none;
  double took_s = 0;   ///< Until the route was there; without one, until it gave up.
  Metrics metrics;     ///< Of the route, allowed or not; means nothing without one.
  std::string broken;  ///< Rules that the check found broken: "turn, climb".

  bool has_route() const { return standing != Standing::none; }
};

/// One contender with one seed.
struct CompareRun {
  std::size_t contender = 0;
  std::uint64_t seed = 0;
  std::vector<CompareMark> marks;  ///< One a time.
  Route route;                     ///< When the last time was up; empty if there was none.
  Verdict verdict;                 ///< Of this route.
  std::size_t routes = 0;          ///< That a peer handed over, and those of them that the check refuses.
  std::size_t refused = 0;
  std::string ending = "finished";  ///< Of a peer: "aborted", "failed", "hung", "rubbish" or "stopped".
  std::string note;                 ///< What is known of a bad ending.
};

struct CompareRefusal {
  std::string name;
  std::string why;
};

struct CompareOptions {
  double seconds = 1;                                ///< > 0.
  std::uint64_t seeds = 5;                           ///< Runs have the seeds 1 to this one.
  std::vector<std::string> only;                     ///< Names of planners and peers; empty: all that can serve.
  std::string peers;                                 ///< Program of the peers; empty: none. See docs/compare.md.
  std::stop_token stop;                              ///< Ends it with what there is.
  std::function<void(const Progress&)> on_progress;  ///< An iteration is a run.
};

struct Comparison {
  World world;
  std::vector<double> times_s;  ///< Upwards; the last one is `seconds`.
  std::uint64_t seeds = 0;
  std::vector<Contender> contenders;
  std::vector<CompareRefusal> refusals;
  std::vector<std::string> notes;  ///< On peers that are not there.
  std::vector<CompareRun> runs;    ///< By seed, then contender: as they were made.
  double lower_bound = 0;          ///< The greatest that any of our planners knows.
  bool stopped = false;
};

/// What a limit of time grants beyond it: planners stop within milliseconds, not at once.
double with_grace(double time_s);

/// Runs every contender for a hundredth, three hundredths, a tenth, three tenths and the whole of the time, one run
/// after another, each on one thread. Ours make a run of its own for each time; a peer hands over each better route
/// with its time, and one run tells of all. Every route is judged by `measure` and `check`. Throws InputError for names
/// in `only` that are not known or cannot serve, and where nothing can.
Comparison compare_planners(const World& world, const CompareOptions& options);

/// The comparison for a terminal, as JSON, as a page, and one line for each run and time.
std::string to_text(const Comparison& comparison);
std::string to_json(const Comparison& comparison);
std::string compare_html(const Comparison& comparison);
std::string compare_csv(const Comparison& comparison);

class OutputFolder;

/// A folder that one comparison writes into.
class CompareFolder {
 public:
  /// Makes and locks the folder. Throws InputError (field `--out`) if it cannot be made or another run holds it.
  explicit CompareFolder(const std::string& folder);
  ~CompareFolder();
  CompareFolder(const CompareFolder&) = delete;
  CompareFolder& operator=(const CompareFolder&) = delete;

  /// Writes compare.html, rows.csv and result.json, and returns their names.
  std::vector<std::string> write(const Comparison& comparison);

 private:
  std::unique_ptr<OutputFolder> output_;
};

}  // namespace alate
