// alate generate: scenarios made by a law.
#include "alate/out/generate.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "alate/core/param_table.hpp"
#include "commands.hpp"
#include "folder.hpp"

namespace alate::cli {

namespace {

constexpr const char* kCorrections = "corrections";

/// The command line as written.
struct GenerateLine {
  Text what, points, law, seed, out;
};

CorrectionRequest read_request(const GenerateLine& line, FaultList& faults) {
  const std::string what = read_required("WHAT", line.what, faults);
  if (!what.empty() && what != kCorrections)
    faults.add(unknown_name({.file = "WHAT"}, "kind of scenario", what, {kCorrections}));
  CorrectionRequest request{.law = read_required("--law", line.law, faults)};
  const auto laws = correction_laws();
  if (!request.law.empty() && std::ranges::find(laws, request.law) == laws.end())
    faults.add(unknown_name({.file = "--law"}, "law", request.law, laws));
  read_required("--points", line.points, faults);
  const auto points = read_whole("--points", line.points, {.min = 1, .max = kMostGeneratedPoints}, faults);
  request.points = static_cast<int>(points.value_or(1));
  request.seed = read_whole("--seed", line.seed, {}, faults).value_or(request.seed);
  return request;
}

int generate(const GenerateLine& line, FaultList faults) {
  const CorrectionRequest request = read_request(line, faults);
  const std::string out = read_required("--out", line.out, faults);
  if (!out.empty()) check_folder(out, faults);
  faults.throw_if_any();
  make_folder(out);
  const auto files = write_corrections(request, out);
  for (const std::string& name : files) fmt::print("Wrote {}\n", (std::filesystem::path(out) / name).string());
  fmt::print("Next: alate plan {}\n", (std::filesystem::path(out) / files.front()).string());
  return kDone;
}

}  // namespace

void add_generate(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<GenerateLine>();
  CLI::App& command = *add_command(app, "generate", "Make a scenario by a law, of any size",
                                   "alate generate corrections --points 10000 --law set1 --seed 1 --out out/field");
  add_text(command, "WHAT", line->what, "corrections: a field of correction points");
  add_text(command, "--points", line->points, fmt::format("correction points, 1 to {}", kMostGeneratedPoints));
  add_text(command, "--law", line->law, fmt::format("density and limits: {}", fmt::join(correction_laws(), ", ")));
  add_text(command, "--seed", line->seed, "seed of all random numbers (default 1)");
  add_text(command, "--out", line->out, "folder for points.csv and scenario.yaml");
  command.callback(
      [&chosen, line] { chosen = [line](FaultList faults) { return generate(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
