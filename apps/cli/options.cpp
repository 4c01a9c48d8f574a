#include "options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <thread>

namespace alate::cli {

namespace {

template <class Number>
std::optional<Number> parse(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

std::string describe(WholeLimits limits) {
  return limits.max == UINT64_MAX ? fmt::format(">= {}", limits.min) : fmt::format("{} to {}", limits.min, limits.max);
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& about, const std::string& example) {
  CLI::App* command = app.add_subcommand(name, about);
  command->footer(fmt::format("\nExample:\n  {}", example));
  command->allow_extras();
  return command;
}

CLI::Option* add_text(CLI::App& command, const std::string& names, Text& value, const std::string& help) {
  return command.add_option_function<std::string>(names, [&value](const std::string& text) { value = text; }, help);
}

void add_list(CLI::App& command, const std::string& name, std::vector<std::string>& values, const std::string& help) {
  command.add_option(name, values, help)->allow_extra_args(false);
}

std::optional<std::uint64_t> read_whole(const std::string& option, const Text& text, WholeLimits limits,
                                        FaultList& faults) {
  if (!text) return std::nullopt;
  const auto value = parse<std::uint64_t>(*text);
  if (value && *value >= limits.min && *value <= limits.max) return value;
  faults.add({.file = option,
              .value = text->empty() ? "nothing" : *text,
              .limit = describe(limits),
              .message = "is not a whole number within its limits"});
  return std::nullopt;
}

int read_threads(const Text& text, FaultList& faults) {
  constexpr unsigned kMaxThreads = 1024;
  const unsigned processors = std::clamp(std::thread::hardware_concurrency(), 1U, kMaxThreads);
  return static_cast<int>(read_whole("--threads", text, {.min = 1, .max = kMaxThreads}, faults).value_or(processors));
}

std::optional<double> read_positive(const std::string& option, const Text& text, const PositiveLimits& limits,
                                    FaultList& faults) {
  if (!text) return std::nullopt;
  const auto value = parse<double>(*text);
  if (value && std::isfinite(*value) && *value > 0 && *value <= limits.max) return value;
  faults.add({.file = option,
              .value = text->empty() ? "nothing" : *text,
              .limit = std::isfinite(limits.max) ? fmt::format("> 0, <= {}", limits.max) : "> 0",
              .unit = limits.unit,
              .message = value ? "out of range" : "is not a number"});
  return std::nullopt;
}

void add_run_options(CLI::App& command, RunLine& line, const std::string& iterations) {
  add_text(command, "--seed", line.seed, "seed of all random numbers (default 1)");
  add_text(command, "--threads", line.threads, "threads, 1 to 1024 (default: one a processor); changes no result");
  add_text(command, "--iterations", line.iterations, iterations);
  add_text(command, "--time-limit", line.time_limit, "seconds of planning at most, > 0; keeps the best so far");
}

RunOptions read_run(const RunLine& line, FaultList& faults) {
  RunOptions options;
  options.iterations = read_whole("--iterations", line.iterations, {.min = 1}, faults);
  options.time_limit_s = read_positive("--time-limit", line.time_limit, {.unit = "s"}, faults);
  options.seed = read_whole("--seed", line.seed, {}, faults).value_or(kDefaultSeed);
  return options;
}

std::string read_required(const std::string& name, const Text& text, FaultList& faults) {
  if (text && !text->empty()) return *text;
  faults.add({.file = name, .message = "is missing on the command line"});
  return {};
}

}  // namespace alate::cli
