// alate compare: planners side by side on one scenario, at equal wall time.
#include "alate/study/compare.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "alate/data/scenario_file.hpp"
#include "commands.hpp"
#include "folder.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"

namespace alate::cli {

namespace {

namespace fs = std::filesystem;

constexpr double kMostSeconds = 86'400;
constexpr std::uint64_t kMostSeeds = 10'000;

/// The command line as written.
struct CompareLine {
  Text scenario, seconds, seeds, peers, out;
  std::vector<std::string> only;
  std::vector<std::string> overrides;
  bool json = false;
};

/// Beside this program; empty if it is not there.
std::string peers_beside() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path() / "alate_peers";
  return !error && access(program.c_str(), X_OK) == 0 ? program.string() : "";
}

/// `--peers none` leaves them out. A name without a folder is one in this folder, not one to be searched for.
std::string read_peers(const Text& text, FaultList& faults) {
  if (!text) return peers_beside();
  if (*text == "none") return "";
  const fs::path program = fs::absolute(*text);
  std::error_code ignored;
  if (!fs::is_regular_file(program, ignored) || access(program.c_str(), X_OK) != 0)
    faults.add({.file = "--peers", .value = *text, .message = "is not a program that can be run"});
  return program.string();
}

CompareOptions read_options(const CompareLine& line, FaultList& faults) {
  CompareOptions options{.only = line.only, .peers = read_peers(line.peers, faults)};
  options.seconds =
      read_positive("--seconds", line.seconds, {.unit = "s", .max = kMostSeconds}, faults).value_or(options.seconds);
  options.seeds = read_whole("--seeds", line.seeds, {.min = 1, .max = kMostSeeds}, faults).value_or(options.seeds);
  if (line.out) check_folder(*line.out, faults);
  return options;
}

std::optional<World> read_world(const CompareLine& line, FaultList& faults) {
  const std::string file = read_required("SCENARIO", line.scenario, faults);
  if (file.empty()) return std::nullopt;
  return faults.collect([&] { return World(load_site(load_scenario(file, line.overrides))); });
}

int compare(const CompareLine& line, FaultList faults) {
  const Interrupt interrupt;  // Before any other thread.
  CompareOptions options = read_options(line, faults);
  const auto world = read_world(line, faults);
  faults.throw_if_any();
  std::unique_ptr<CompareFolder> folder;
  if (line.out) folder = std::make_unique<CompareFolder>(*line.out);
  ProgressBar bar("run");
  options.stop = interrupt.token();
  options.on_progress = [&bar](const Progress& progress) { bar.draw(progress); };
  const Comparison comparison = compare_planners(*world, options);
  const auto files = folder ? folder->write(comparison) : std::vector<std::string>{};
  fmt::print("{}", line.json ? to_json(comparison) : to_text(comparison));
  if (!line.json && !files.empty()) {
    fmt::print("\nFiles, the page first:\n");
    for (const std::string& name : files) fmt::print("  {}\n", (fs::path(*line.out) / name).string());
  }
  return comparison.stopped ? kInterrupted : kDone;
}

}  // namespace

void add_compare(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<CompareLine>();
  CLI::App& command = *add_command(app, "compare", "Run planners side by side on a scenario, at equal wall time",
                                   "alate compare scenario.yaml --seconds 10 --seeds 5 --out out/compare");
  add_text(command, "SCENARIO", line->scenario, "scenario file (YAML or JSON); - reads standard input");
  add_text(command, "--seconds", line->seconds, "seconds for each run, > 0 (default 1)");
  add_text(command, "--seeds", line->seeds, "runs of each planner with chance, >= 1 (default 5)");
  add_list(command, "--only", line->only, "name of a planner to compare; may be repeated (default: all that can)");
  add_text(command, "--peers", line->peers,
           "program with planners of others (default: alate_peers beside alate, if it is there); none: without");
  add_list(command, "--override", line->overrides, "key.path=VALUE of the scenario; may be repeated");
  add_text(command, "--out", line->out, "folder for compare.html, rows.csv and result.json");
  command.add_flag("--json", line->json, "result as JSON on standard output, and nothing else");
  command.callback(
      [&chosen, line] { chosen = [line](FaultList faults) { return compare(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
