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
constexpr const char* kTerrain = "terrain";

/// The command line as written.
struct GenerateLine {
  Text what, points, side, law, seed, out;
};

std::string read_law(const Text& text, const std::vector<std::string>& laws, FaultList& faults) {
  std::string law = read_required("--law", text, faults);
  if (!law.empty() && std::ranges::find(laws, law) == laws.end())
    faults.add(unknown_name({.file = "--law"}, "law", law, laws));
  return law;
}

void refuse(const char* option, const Text& text, const std::string& what, FaultList& faults) {
  if (text) faults.add({.file = option, .value = *text, .message = fmt::format("has no meaning for {}", what)});
}

CorrectionRequest read_corrections(const GenerateLine& line, FaultList& faults) {
  CorrectionRequest request{.law = read_law(line.law, correction_laws(), faults)};
  read_required("--points", line.points, faults);
  const auto points = read_whole("--points", line.points, {.min = 1, .max = kMostGeneratedPoints}, faults);
  request.points = static_cast<int>(points.value_or(1));
  request.seed = read_whole("--seed", line.seed, {}, faults).value_or(request.seed);
  refuse("--side", line.side, kCorrections, faults);
  return request;
}

TerrainRequest read_terrain(const GenerateLine& line, FaultList& faults) {
  TerrainRequest request{.law = read_law(line.law, terrain_laws(), faults)};
  const auto side = read_whole("--side", line.side, {.min = kLeastGeneratedSide, .max = kMostGeneratedSide}, faults);
  request.side = static_cast<int>(side.value_or(static_cast<std::uint64_t>(request.side)));
  request.seed = read_whole("--seed", line.seed, {}, faults).value_or(request.seed);
  refuse("--points", line.points, kTerrain, faults);
  return request;
}

int generate(const GenerateLine& line, FaultList faults) {
  const std::string what = read_required("WHAT", line.what, faults);
  if (!what.empty() && what != kCorrections && what != kTerrain)
    faults.add(unknown_name({.file = "WHAT"}, "kind of scenario", what, {kCorrections, kTerrain}));
  const std::string out = read_required("--out", line.out, faults);
  if (!out.empty()) check_folder(out, faults);
  const auto write = [&](const auto& request, const auto& write_files) {
    faults.throw_if_any();
    make_folder(out);
    return write_files(request, out);
  };
  const auto files = what == kTerrain ? write(read_terrain(line, faults), write_terrain)
                                      : write(read_corrections(line, faults), write_corrections);
  for (const std::string& name : files) fmt::print("Wrote {}\n", (std::filesystem::path(out) / name).string());
  fmt::print("Next: alate plan {}\n", (std::filesystem::path(out) / files.front()).string());
  return kDone;
}

}  // namespace

void add_generate(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<GenerateLine>();
  CLI::App& command = *add_command(app, "generate", "Make a scenario by a law, of any size",
                                   "alate generate corrections --points 10000 --law set1 --seed 1 --out out/field");
  add_text(command, "WHAT", line->what, "corrections: a field of correction points; terrain: ground to fly over");
  add_text(command, "--points", line->points, fmt::format("correction points, 1 to {}", kMostGeneratedPoints));
  add_text(command, "--side", line->side,
           fmt::format("posts along a side of the terrain, {} to {}, 10 m apart (default {})", kLeastGeneratedSide,
                       kMostGeneratedSide, TerrainRequest{}.side));
  add_text(command, "--law", line->law,
           fmt::format("of corrections, density and limits: {}; of terrain: {}", fmt::join(correction_laws(), ", "),
                       fmt::join(terrain_laws(), ", ")));
  add_text(command, "--seed", line->seed, "seed of all random numbers (default 1)");
  add_text(command, "--out", line->out, "folder for scenario.yaml and points.csv or terrain.tif");
  command.callback(
      [&chosen, line] { chosen = [line](FaultList faults) { return generate(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
