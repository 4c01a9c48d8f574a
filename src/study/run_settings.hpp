// What is needed to do a reproduction again, as every page lists it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "study/experiment.hpp"

namespace alate {

using RunSettings = std::vector<std::pair<std::string, ParamValue>>;

/// Version, seeds, threads, processor and compiler.
RunSettings run_settings(std::uint64_t seeds, int threads);

/// Appends each method of the experiment with all its parameters, as resolved for the first case.
void append_methods(const Experiment& experiment, RunSettings& settings);

}  // namespace alate
