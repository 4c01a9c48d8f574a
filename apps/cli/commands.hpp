// The commands. Each adds itself to the command line and, when it is the one asked for, puts what is to be run
// into `chosen`.
#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "options.hpp"

namespace alate::cli {

inline constexpr int kDone = 0;
inline constexpr int kNoGoodRoute = 1;
inline constexpr int kBadInput = 2;
inline constexpr int kInternalFault = 3;
inline constexpr int kInterrupted = 130;

/// Returns an exit code. Gets the faults that parsing found, adds its own and throws them all at once.
using Command = std::function<int(FaultList)>;

void add_plan(CLI::App& app, Command& chosen);
void add_replan(CLI::App& app, Command& chosen);
void add_compare(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_planners(CLI::App& app, Command& chosen);
void add_reproduce(CLI::App& app, Command& chosen);
void add_study(CLI::App& app, Command& chosen);
void add_scen(CLI::App& app, Command& chosen);
void add_generate(CLI::App& app, Command& chosen);
void add_init(CLI::App& app, Command& chosen);
void add_schema(CLI::App& app, Command& chosen);

}  // namespace alate::cli
