// How a run ends: its result written, shown, and told by the exit code.
#pragma once

#include "alate/out/result.hpp"
#include "interrupt.hpp"
#include "options.hpp"

namespace alate::cli {

/// Where a result goes.
struct Delivery {
  Text out;  ///< Folder.
  bool json = false;
};

/// --out and --json.
void add_delivery_options(CLI::App& command, Delivery& delivery);

/// Metrics, verdict and warnings of a plan.
Result result_of(const Site& site, const ChosenPlanner& planner, Plan plan);

/// Writes, shows; returns the exit code. A route that cannot be written is still shown.
int deliver(Result& result, const Delivery& delivery, const Interrupt& interrupt);

}  // namespace alate::cli
