// alate scen: a planner on the field's benchmark maps.
#include "alate/study/scen.hpp"

#include <fmt/core.h>

#include <memory>

#include "commands.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"

namespace alate::cli {

namespace {

/// The command line as written.
struct ScenLine {
  Text file, planner, preset, rows;
  bool json = false;
};

int scen(const ScenLine& line, FaultList faults) {
  const Interrupt interrupt;  // Before any other thread.
  ProgressBar bar;
  const std::string file = read_required("FILE", line.file, faults);
  const ScenOptions options{.request = {.name = line.planner.value_or(""), .preset = line.preset.value_or("")},
                            .rows = read_whole("--rows", line.rows, {.min = 1}, faults),
                            .stop = interrupt.token(),
                            .on_progress = [&bar](const Progress& progress) { bar.draw(progress); }};
  faults.throw_if_any();
  const ScenSummary summary = run_scen(file, options);
  fmt::print("{}", line.json ? to_json(summary) : to_text(summary));
  if (summary.stopped) return kInterrupted;
  return summary.solved == summary.rows ? kDone : kNoGoodRoute;
}

}  // namespace

void add_scen(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<ScenLine>();
  CLI::App& command = *add_command(app, "scen", "Run a planner on the tasks of a benchmark map (Moving AI)",
                                   "alate scen arena.map.scen --planner jps --rows 100");
  add_text(command, "FILE", line->file, "tasks (.map.scen, .3dmap.3dscen); the map that they name lies beside");
  add_text(command, "--planner", line->planner, "planner to use (see alate planners)");
  add_text(command, "--preset", line->preset, "named set of the planner's parameters");
  add_text(command, "--rows", line->rows, "so many rows, those with the longest optimum (default: all)");
  command.add_flag("--json", line->json, "result as JSON on standard output, and nothing else");
  command.callback([&chosen, line] { chosen = [line](FaultList faults) { return scen(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
