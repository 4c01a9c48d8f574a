// Values of options: taken as text from the command line and read here, so that every fault is told at once.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/core/run_context.hpp"

namespace alate::cli {

/// Faults of one run, gathered until there is nothing more to find out.
class FaultList {
 public:
  void add(Fault fault) { faults_.push_back(std::move(fault)); }

  /// What `read` returns, or nothing if it throws InputError; its faults are kept.
  template <class Read>
  auto collect(Read&& read) -> std::optional<decltype(read())> {
    try {
      return std::forward<Read>(read)();
    } catch (const InputError& error) {
      faults_.insert(faults_.end(), error.faults().begin(), error.faults().end());
      return std::nullopt;
    }
  }

  void throw_if_any() const { alate::throw_if_any(faults_); }

 private:
  std::vector<Fault> faults_;
};

/// An option as the user wrote it; nothing if it was not given.
using Text = std::optional<std::string>;

/// A command of its own, with an example below its help.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& about, const std::string& example);

/// `names` in CLI11's way: "--seed", or "SCENARIO" for a place on the line.
CLI::Option* add_text(CLI::App& command, const std::string& names, Text& value, const std::string& help);

/// An option that may be given several times, one value each.
void add_list(CLI::App& command, const std::string& name, std::vector<std::string>& values, const std::string& help);

struct WholeLimits {
  std::uint64_t min = 0;
  std::uint64_t max = UINT64_MAX;
};

std::optional<std::uint64_t> read_whole(const std::string& option, const Text& text, WholeLimits limits,
                                        FaultList& faults);

/// Of --threads; one a processor if it was not given.
int read_threads(const Text& text, FaultList& faults);

struct PositiveLimits {
  std::string unit;
  double max = std::numeric_limits<double>::infinity();
};

/// What bounds a run of a planner.
struct RunLine {
  Text seed, threads, iterations, time_limit;
};

/// The options of a RunLine; `iterations` tells of those.
void add_run_options(CLI::App& command, RunLine& line, const std::string& iterations);

/// All of it but the threads, which are the executor's.
RunOptions read_run(const RunLine& line, FaultList& faults);

/// A finite number above zero.
std::optional<double> read_positive(const std::string& option, const Text& text, const PositiveLimits& limits,
                                    FaultList& faults);

/// The value of something that must be on the line; empty, with a fault, if it is not.
std::string read_required(const std::string& name, const Text& text, FaultList& faults);

}  // namespace alate::cli
