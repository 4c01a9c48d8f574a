// What Konatowski and Pawlowski 2019 report, and the cases on which we try it.
//
// Source: S. Konatowski, P. Pawlowski, "Application of the ACO algorithm for UAV path planning", Przeglad
// Elektrotechniczny 2019. The paper shows its threats in Figure 3 only, which cannot be read off: the layouts here
// are ours.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/experiment.hpp"

namespace alate::konatowski2019 {

/// One row of the paper's results.
struct Published {
  double fuel = 0;
  double threat = 0;
  double initial = 0;
  double best = 0;
  double gain_percent = 0;
};

inline constexpr std::array<Published, 3> kPublished{
    {{0.2, 0.8, 55.24, 30.89, 44.1}, {0.5, 0.5, 84.27, 72.69, 13.7}, {0.8, 0.2, 114.16, 109.97, 3.7}}};
inline constexpr double kPublishedRounding = 0.005;  ///< Costs are printed to two digits.
inline constexpr double kGainRounding = 0.05;        ///< Gains to one.

inline constexpr std::uint64_t kSeeds = 10;
inline constexpr std::uint64_t kIterations = 180;
inline constexpr double kEvaporation = 0.8;
inline constexpr double kDeposit = 50;  ///< Q.

struct Layout {
  std::string name;
  std::string scenario;  ///< YAML, fuel and threat weighing 0.5 each.
  /// Best costs known from all methods tried so far, in the order of kPublished; of F good to 1 %.
  std::array<double, kPublished.size()> best_known{};
};

/// The paper states none; about 3.4 times the direct distance.
inline constexpr std::int64_t kStepLimit = 40;

/// A, C, F.
const std::vector<Layout>& layouts();

/// Start and goal without any threat.
const Layout& open_layout();

/// "A-0.2".
std::string case_name(const Layout& layout, const Published& row);

/// The layout under the weights of the row.
StudyCase make_case(const Layout& layout, const Published& row);

/// The methods of the comparison, in the order of tables.
std::vector<StudyMethod> methods(const std::optional<std::uint64_t>& iterations);

/// Names of methods that claims refer to.
inline constexpr const char* kLiteral = "Ant System, 50 ants";
inline constexpr const char* kLiteral20 = "Ant System, 20 ants";
inline constexpr const char* kLiteral100 = "Ant System, 100 ants";
inline constexpr const char* kRank = "rank-based";
inline constexpr const char* kMaxMin = "MAX-MIN";
inline constexpr const char* kAcs = "Ant Colony System";
inline constexpr const char* kNoPheromone = "no pheromone";
inline constexpr const char* kGreedyJ = "greedy on J";
inline constexpr const char* kGreedyJh = "greedy on J+h";
inline constexpr const char* kBeam = "beam";
inline constexpr const char* kGuided = "guided";

}  // namespace alate::konatowski2019
