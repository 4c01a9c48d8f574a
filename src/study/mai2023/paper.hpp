// What Mai et al. 2023 claim, the scenes we test it on, and the ways in which it can be read.
//
// Source: X. Mai, N. Dong, S. Liu, H. Chen, "UAV path planning based on a dual-strategy ant colony optimization
// algorithm", Intelligence & Robotics 3(4) (2023) 666-84, doi 10.20517/ir.2023.37. Most of its equations and two of its
// three terrains were available, no parameter value and no figure of any result: `notes` say what follows from that.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/experiment.hpp"

namespace alate::mai2023 {

inline constexpr std::uint64_t kSeeds = 30;
inline constexpr std::uint64_t kIterations = 500;
inline constexpr std::uint64_t kSeedsToReadings = 3;  ///< Other readings get so many times fewer seeds.

/// Index into kSceneNames.
using Scene = std::size_t;
inline constexpr Scene kSimple = 0;
inline constexpr Scene kMedium = 1;
inline constexpr Scene kOurs = 2;
inline constexpr std::array<Scene, 3> kScenes{kSimple, kMedium, kOurs};
inline constexpr std::array<const char*, 3> kSceneNames{"simple", "medium", "ours"};

/// How peaks make a ground.
inline constexpr const char* kSum = "sum";
inline constexpr const char* kMax = "max";

/// The scenario of a scene, YAML. Peaks of `simple` and `medium` are the paper's, of `ours` the first four.
std::string scenario_text(Scene scene, const std::string& combine = kSum);

/// A planner parameter that differs from the preset.
struct Setting {
  const char* name;
  const char* value;
};

/// One way to read what the paper leaves open.
struct Reading {
  std::string name;
  std::string help;
  std::vector<Setting> both;
  std::vector<Setting> aco;  ///< The baseline alone.
  std::vector<Setting> mai;  ///< The paper's method alone.
  const char* combine = kSum;
};

/// The first is that of the main runs.
const std::vector<Reading>& readings();

/// The paper's method, its baseline, their parts, and what they must be held against: the same budget of walks for all
/// colonies.
std::vector<StudyMethod> main_methods(const std::optional<std::uint64_t>& iterations);

/// kAco and kMai under one reading.
std::vector<StudyMethod> reading_methods(const Reading& reading, const std::optional<std::uint64_t>& iterations);

/// What must be known before any figure is read, in plain sentences.
std::vector<std::string> notes();

inline constexpr const char* kAco = "ACO";
inline constexpr const char* kMai = "Mai 2023";
inline constexpr const char* kSelection = "ACO + strategy 1";
inline constexpr const char* kUpdate = "ACO + strategy 2";
inline constexpr const char* kAcoBlind = "ACO, no pheromone";
inline constexpr const char* kMaiBlind = "Mai 2023, no pheromone";
inline constexpr const char* kNearest = "ACO, 1/d";
inline constexpr const char* kGreedy = "greedy";
inline constexpr const char* kImproved = "improved";
inline constexpr const char* kImprovedF = "improved, for F";

inline constexpr const char* kAsChosen = "as chosen";
inline constexpr const char* kLittlePheromone = "Q = 10";

}  // namespace alate::mai2023
