// alate reproduce: a paper's claims beside our own runs.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "alate/study/reproduce.hpp"
#include "commands.hpp"
#include "folder.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"

namespace alate::cli {

namespace {

/// The command line as written.
struct ReproduceLine {
  Text paper, seeds, iterations, threads, data, out;
  bool json = false;
};

/// Where data lie that alate does not ship: the option, the environment, then a folder beside the project's.
std::string data_folder(const Text& option) {
  if (option) return *option;
  const char* set = std::getenv("ALATE_DATA");
  return set != nullptr && *set != '\0' ? set : "../shared/data/correction-points";
}

/// After the result has been shown, so that no long run is lost to a folder that cannot be written.
void write(const Reproduction& result, const ReproduceLine& line) {
  const auto files = write_reproduction(*line.out, result);
  if (line.json) return;
  fmt::print("\nFiles, the page first:\n");
  for (const std::string& name : files) fmt::print("  {}\n", (std::filesystem::path(*line.out) / name).string());
}

int reproduce_paper(const ReproduceLine& line, FaultList faults) {
  const Interrupt interrupt;  // Before any other thread.
  const std::string paper = read_required("PAPER", line.paper, faults);
  if (!paper.empty())
    faults.collect([&] {
      require_reproducible(paper);
      return true;
    });
  ProgressBar bar("run");
  ReproduceOptions options{.stop = interrupt.token(), .on_progress = [&bar](const Progress& p) { bar.draw(p); }};
  options.seeds = read_whole("--seeds", line.seeds, {.min = 1, .max = 1000}, faults);
  options.data = data_folder(line.data);
  options.iterations = read_whole("--iterations", line.iterations, {.min = 1, .max = 1'000'000}, faults);
  const int threads = read_threads(line.threads, faults);
  if (line.out) check_folder(*line.out, faults);
  faults.throw_if_any();
  if (line.out) make_folder(*line.out);

  Executor executor(threads);
  const auto result = reproduce(paper, executor, options);
  if (!result) {
    fmt::print(stderr, "alate: interrupted; half a comparison says nothing, so nothing is shown or written\n");
    return kInterrupted;
  }
  fmt::print("{}", line.json ? to_json(*result) : to_text(*result));
  if (line.out) write(*result, line);
  return kDone;
}

}  // namespace

void add_reproduce(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<ReproduceLine>();
  CLI::App& command = *add_command(app, "reproduce", "Put a paper's claims to the test, with a verdict for each",
                                   "alate reproduce konatowski2019 --out out/konatowski2019");
  add_text(command, "PAPER", line->paper, fmt::format("one of: {}", fmt::join(reproducible_papers(), ", ")));
  add_text(command, "--seeds", line->seeds,
           "seeds 1 to N, up to 1000 (default: 10; 20 for zhou2020, 30 for mai2023 and yin2021)");
  add_text(command, "--iterations", line->iterations, "iterations of colonies (default: as published)");
  add_text(command, "--threads", line->threads, "threads, 1 to 1024 (default: one a processor); changes times only");
  add_text(command, "--data", line->data,
           "folder of the paper's data (default: ALATE_DATA, then ../shared/data/correction-points)");
  add_text(command, "--out", line->out, "folder for reproduce.html and reproduce.json");
  command.add_flag("--json", line->json, "result as JSON on standard output, and nothing else");
  command.callback(
      [&chosen, line] { chosen = [line](FaultList faults) { return reproduce_paper(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
