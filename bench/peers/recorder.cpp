#include "recorder.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "out/json_parts.hpp"

namespace alate::peers {

bool Recorder::offer(const Way& way) {
  const auto route = legs_.route(way);
  if (!route) return false;
  const double cost = legs_.cost(*route);
  const std::lock_guard lock(mutex_);
  constexpr double kGain = 1e-5;  // of the cost; less is not worth a line
  if (!(cost < best_cost_ * (1 - kGain)) && best_cost_ < std::numeric_limits<double>::infinity()) return false;
  const double time = time_s();
  if (time > seconds_) return false;
  best_cost_ = cost;
  write(*route, time);
  return true;
}

void Recorder::write(const Route& route, double time_s) {
  const double from = clock_.elapsed_s();
  const nlohmann::ordered_json line{{"schema", 1}, {"time_s", time_s}, {"route", route_json(site_, route)}};
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
  written_s_ = written_s_ + clock_.elapsed_s() - from;
}

}  // namespace alate::peers
