// What a planner may use of the outside: budget, clock, cancelling, threads, seed, progress.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "alate/core/executor.hpp"

namespace alate {

enum class Stop { finished, budget, deadline, cancelled };

const char* to_string(Stop stop);

/// How far a planner is; sent to the sink of the RunContext, from the planner's own thread.
struct Progress {
  std::uint64_t iteration = 0;
  double fraction = 0;         ///< Of the budget used, 0 to 1; 0 where nothing limits the run.
  std::optional<double> best;  ///< Best cost so far.
};

inline constexpr std::uint64_t kDefaultSeed = 1;

struct RunOptions {
  std::optional<std::uint64_t> iterations;  ///< >= 1; none: the planner's default, or no limit under a time limit.
  std::optional<double> time_limit_s;       ///< > 0.
  std::uint64_t seed = kDefaultSeed;
  std::stop_token stop;
  std::function<void(const Progress&)> on_progress;
};

/// One run of one planner. The clock starts when this is made. Only `start_iteration` counts the budget;
/// `keep_going` may be polled from any thread, once per iteration or every 1024 expansions.
class RunContext {
 public:
  RunContext(Executor& executor, RunOptions options);

  /// True while neither the deadline nor a cancel has come. Once false, it stays false.
  bool keep_going();

  /// Counts one iteration and is true if it may run: within the budget (`default_iterations` if neither
  /// iterations nor a time limit were given), the deadline and without a cancel.
  bool start_iteration(std::uint64_t default_iterations);

  /// Says how far the run is. Cheap; the sink is called at most ten times a second.
  void report(std::optional<double> best);

  /// Why the run ended: `finished` unless a limit was met. Call it after the last iteration.
  Stop stop() const;

  std::uint64_t iterations() const { return iteration_; }
  /// Iterations allowed, for schedules; 0: not limited, or none has started.
  std::uint64_t iteration_limit() const { return limit_; }
  std::uint64_t seed() const { return options_.seed; }
  Executor& executor() const { return executor_; }
  double elapsed_s() const;

 private:
  using Clock = std::chrono::steady_clock;
  double fraction() const;

  Executor& executor_;
  RunOptions options_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point reported_ = started_;
  std::uint64_t iteration_ = 0;
  std::uint64_t limit_ = 0;  ///< Iterations allowed; 0: not limited.
  std::atomic<Stop> stop_{Stop::finished};
};

}  // namespace alate
