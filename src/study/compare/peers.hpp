// Planners of other programs, and what they hand over (docs/compare.md tells the protocol).
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"
#include "study/compare/peer_process.hpp"

namespace alate {

struct PeerPlanner {
  std::string name;
  std::string help;
  std::string refuses;  ///< Why it cannot serve the scenario; empty if it can.
};

struct PeerList {
  std::vector<PeerPlanner> planners;
  PeerEnd end;  ///< Of the program that was asked.
};

PeerList list_peers(const std::string& program, const Site& site, const std::stop_token& stop);

struct PeerTask {
  std::string program;
  std::string name;
  double seconds = 1;
  std::uint64_t seed = 0;
};

struct PeerRoute {
  double time_s = 0;  ///< Of planning, reading the scenario excluded, by the peer's own word.
  Route route;
};

struct PeerRun {
  std::vector<PeerRoute> routes;  ///< As they came.
  PeerEnd end;
};

PeerRun run_peer(const PeerTask& task, const Site& site, const std::stop_token& stop);

}  // namespace alate
