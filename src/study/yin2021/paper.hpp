// What Yin et al. 2021 report, the maps we test it on, and the ways in which it can be read.
//
// Source: Y. Yin, R. Zhen, X. Wu, C. Zhang, X. Wu, "Research on UAV route planning based on adaptive multi heuristic
// ant colony algorithm", J. Hebei Univ. Sci. Technol. 42(1) (2021) 38-47. Its one baseline: L. Li, H. Li, N. Shan,
// Computer Engineering and Applications 55(5) (2019) 219-225. Only the prose of the first was available, and a public
// program for the second: what is built on them is said in `notes`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/experiment.hpp"

namespace alate::yin2021 {

inline constexpr std::uint64_t kSeeds = 30;  ///< Runs on a map, as published.
inline constexpr std::uint64_t kIterations = 30;
inline constexpr std::size_t kMaps = 40;              ///< Of each size; the paper has one.
inline constexpr std::uint64_t kSeedsToReadings = 3;  ///< Other readings get so many times fewer seeds.

/// Index into kSizes, and into what a study holds by size.
using Size = std::size_t;
inline constexpr Size kSmall = 0;
inline constexpr Size kLarge = 1;
inline constexpr std::array<int, 2> kSizes{10, 30};  ///< Cells along a side.

inline constexpr std::array<Size, 2> kBoth{kSmall, kLarge};

/// "10x10".
std::string size_name(Size size);

/// Published changes from the baseline to the new method.
inline constexpr double kLengthChange_percent = -6.4;
inline constexpr double kVarianceChange_percent = -85.78;

/// A planner parameter that differs from the main reading.
struct Setting {
  const char* name;
  const char* value;
};

/// One way to read what the paper leaves open. Both methods have the same settings but for what `li` and `yin` say.
struct Reading {
  std::string name;
  std::string help;
  std::vector<Setting> li;   ///< Empty: as in the main reading.
  std::vector<Setting> yin;  ///< As above.
};

/// The first is the main one, everything as meant.
const std::vector<Reading>& readings();

/// Index of the reading called `name`.
std::size_t reading_index(std::string_view name);

/// The paper's method, its baseline, and what they must be held against; the same budget of walks for all but greedy.
std::vector<StudyMethod> main_methods(const std::optional<std::uint64_t>& iterations);

/// The methods of all readings, the main one again: over as few seeds as the others.
std::vector<StudyMethod> reading_methods(const std::optional<std::uint64_t>& iterations);

/// The scenario of a map, YAML.
std::string scenario_text(Size size, int seed);

/// What must be known before any figure is read, in plain sentences.
std::vector<std::string> notes();

inline constexpr const char* kLi = "Li 2019";
inline constexpr const char* kYin = "Yin 2021";
inline constexpr const char* kImproved = "grid-aco, improved";
inline constexpr const char* kNoPheromone = "Li 2019, no pheromone";
inline constexpr const char* kGreedy = "greedy";

inline constexpr const char* kAsMeant = "as meant";
inline constexpr const char* kAsCoded = "as coded";
inline constexpr const char* kHeightsAsCoded = "heights as coded";
inline constexpr const char* kBoundsAsCoded = "bounds as coded";
inline constexpr const char* kNoBounds = "no bounds";
inline constexpr const char* kStepFactor = "1/d in Yin only";

/// Name of a reading's method: "Li 2019, as coded".
std::string method_name(const char* method, const Reading& reading);

}  // namespace alate::yin2021
