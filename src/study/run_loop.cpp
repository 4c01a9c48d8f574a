#include "study/run_loop.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace alate {

namespace {

/// Counts finished runs and tells the sink.
class Counter {
 public:
  explicit Counter(const RunLoop& loop) : loop_(loop) {}

  /// Of shared work, all that was handed out before counts as done.
  void finish(std::size_t index) {
    const std::lock_guard lock(mutex_);
    done_ = loop_.next ? std::max<std::uint64_t>(done_, index + 1) : done_ + 1;
    if (!loop_.on_progress) return;
    loop_.on_progress({.iteration = done_, .fraction = static_cast<double>(done_) / static_cast<double>(loop_.count)});
  }

 private:
  const RunLoop& loop_;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
};

}  // namespace

StudyRun run_once(const Planner& planner, const Problem& problem, RunOptions options) {
  Executor alone(1);
  StudyRun run{.seed = options.seed};
  RunContext context(alone, std::move(options));
  run.plan = planner.plan(problem, context);
  run.wall_s = context.elapsed_s();
  const Site& site = problem.world.site();
  run.metrics = measure(site, run.plan.route);
  run.passed = !run.plan.route.empty() && check(site, run.plan.route).ok();
  return run;
}

bool run_all(const RunLoop& loop, Executor& executor) {
  Counter counter(loop);
  std::atomic<std::size_t> own{0};
  const auto next = [&] { return loop.next ? loop.next() : own++; };
  // One run after another, not pieces of many: near the end no thread may be left with a whole piece.
  const auto work = [&] {
    for (std::size_t i = next(); i < loop.count && !loop.stop.stop_requested(); i = next()) {
      loop.run(i);
      counter.finish(i);
    }
  };
  executor.for_ranges(static_cast<std::size_t>(executor.threads()), [&](std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin) work();
  });
  return !loop.stop.stop_requested();
}

}  // namespace alate
