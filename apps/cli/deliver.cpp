#include "deliver.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "commands.hpp"
#include "output.hpp"

namespace alate::cli {

namespace {

namespace fs = std::filesystem;

/// The fault becomes a warning, and the exit code.
int write(const std::string& folder, Result& result) {
  try {
    write_results(folder, result);
    return kDone;
  } catch (const InputError& error) {
    result.warnings.push_back(fmt::format("not written: {}", error.what()));
    return kBadInput;
  } catch (const std::exception& error) {
    result.warnings.push_back(fmt::format("not written: {}", error.what()));
    return kInternalFault;
  }
}

void show(const Result& result, const Delivery& delivery) {
  if (delivery.json) {
    fmt::print("{}\n", to_json(result));
    return;
  }
  fmt::print("{}", describe(result));
  if (result.files.empty()) return;
  std::vector<std::string> names = result.files;
  std::ranges::stable_partition(names, [](const std::string& name) { return name == "report.html"; });
  fmt::print("Files, the report first:\n");
  for (const std::string& name : names) fmt::print("  {}\n", (fs::path(*delivery.out) / name).string());
}

}  // namespace

void add_delivery_options(CLI::App& command, Delivery& delivery) {
  add_text(command, "--out", delivery.out, "folder for the report, mission files and result.json");
  command.add_flag("--json", delivery.json, "result as JSON on standard output, and nothing else");
}

Result result_of(const Site& site, const ChosenPlanner& planner, Plan plan) {
  Result result{.site = site, .planner = planner, .plan = std::move(plan)};
  result.metrics = measure(site, result.plan.route);
  result.verdict = check(site, result.plan.route);
  result.warnings = site.warnings;
  return result;
}

int deliver(Result& result, const Delivery& delivery, const Interrupt& interrupt) {
  const int written = delivery.out ? write(*delivery.out, result) : kDone;
  show(result, delivery);
  if (written != kDone) {
    fmt::print(stderr, "alate: {}\n", result.warnings.back());
    return written;
  }
  if (interrupt.requested()) return kInterrupted;
  return !result.plan.route.empty() && result.verdict.ok() ? kDone : kNoGoodRoute;
}

}  // namespace alate::cli
