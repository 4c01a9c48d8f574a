// The planners of OMPL, each run for the whole time.
#pragma once

#include <span>
#include <string_view>

#include "flight_space.hpp"
#include "recorder.hpp"

namespace alate::peers {

struct Rival {
  std::string_view name;
  std::string_view help;
  void (*run)(const FlightLegs& legs, Recorder& recorder);
};

std::span<const Rival> rivals();

/// The waypoints of a path of OMPL.
Way way_of(const ob::PathPtr& path);

/// RRTConnect restarted, every way made shorter; half of the time goes into perturbing the best ones if `elites`.
void run_restarts(const FlightLegs& legs, Recorder& recorder, bool elites);

}  // namespace alate::peers
