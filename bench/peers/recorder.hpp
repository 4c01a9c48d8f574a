// Hands over routes as they get better, each with the planning time it took.
#pragma once

#include <atomic>
#include <limits>
#include <mutex>

#include "alate/core/run_context.hpp"
#include "flight_legs.hpp"

namespace alate::peers {

/// May be used by several threads at once. Turning a way into a route counts as planning, writing it does not.
class Recorder {
 public:
  /// The clock starts here, so that what is worked out of the ground beforehand counts, as it does for our planners.
  Recorder(const Problem& problem, double seconds) : seconds_(seconds), site_(problem.world.site()), legs_(problem) {}

  const FlightLegs& legs() const { return legs_; }
  double time_s() const { return clock_.elapsed_s() - written_s_; }
  bool is_on() const { return time_s() < seconds_; }
  double seconds() const { return seconds_; }
  /// Of the best route; infinite before the first.
  double best_cost() const { return best_cost_; }

  /// Writes the route of the way as a line if it is the best so far; true then.
  bool offer(const Way& way);

 private:
  void write(const Route& route, double time_s);

  Executor alone_{1};
  RunContext clock_{alone_, {}};
  double seconds_;
  const Site& site_;
  FlightLegs legs_;
  std::mutex mutex_;
  std::atomic<double> written_s_ = 0;
  std::atomic<double> best_cost_ = std::numeric_limits<double>::infinity();
};

}  // namespace alate::peers
