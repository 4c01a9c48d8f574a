#include "alate/core/run_context.hpp"

#include <algorithm>
#include <cassert>

namespace alate {

namespace {

using namespace std::chrono_literals;
constexpr auto kReportEvery = 100ms;

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

const char* to_string(Stop stop) {
  switch (stop) {
    case Stop::finished:
      return "finished";
    case Stop::budget:
      return "budget";
    case Stop::deadline:
      return "deadline";
    case Stop::cancelled:
      return "cancelled";
  }
  return "";
}

RunContext::RunContext(Executor& executor, RunOptions options) : executor_(executor), options_(std::move(options)) {
  assert(!options_.iterations || *options_.iterations >= 1);
  assert(!options_.time_limit_s || *options_.time_limit_s > 0);
}

bool RunContext::keep_going() {
  if (const Stop stopped = stop_.load(std::memory_order_relaxed);
      stopped == Stop::cancelled || stopped == Stop::deadline)
    return false;
  if (options_.stop.stop_requested()) {
    stop_ = Stop::cancelled;
    return false;
  }
  if (options_.time_limit_s && elapsed_s() >= *options_.time_limit_s) {
    stop_ = Stop::deadline;
    return false;
  }
  return true;
}

bool RunContext::start_iteration(std::uint64_t default_iterations) {
  if (!keep_going()) return false;
  const bool unlimited = !options_.iterations && options_.time_limit_s;
  limit_ = unlimited ? 0 : options_.iterations.value_or(default_iterations);
  if (limit_ != 0 && iteration_ >= limit_) {
    if (options_.iterations) stop_ = Stop::budget;
    return false;
  }
  ++iteration_;
  return true;
}

void RunContext::report(std::optional<double> best) {
  if (!options_.on_progress) return;
  const auto now = Clock::now();
  if (now - reported_ < kReportEvery) return;
  reported_ = now;
  options_.on_progress({.iteration = iteration_, .fraction = fraction(), .best = best});
}

Stop RunContext::stop() const { return stop_; }

double RunContext::elapsed_s() const { return seconds(Clock::now() - started_); }

double RunContext::fraction() const {
  double used = limit_ == 0 ? 0 : static_cast<double>(iteration_) / static_cast<double>(limit_);
  if (options_.time_limit_s) used = std::max(used, elapsed_s() / *options_.time_limit_s);
  return std::min(used, 1.0);
}

}  // namespace alate
