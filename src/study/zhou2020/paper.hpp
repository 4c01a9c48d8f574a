// What Zhou et al. 2020 and others report on the contest's two sets of correction points.
//
// Sources: D. Zhou, S. Xiong, Y. Liu, H. Tan, J. Chen, "Trajectory Planning Algorithm of UAV Based on System
// Positioning Accuracy Constraints", Electronics 2020, 9(2), 250 (its tables 2, 3 and 5); prize papers of problem F of
// the 16th China Post-Graduate Mathematical Contest in Modeling (2019); QPromise/Route-Planning; Niu 2025, doi
// 10.12677/csa.2025.154092; Journal of Mathematics in Industry 10:26 (2020).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "alate/core/scenario.hpp"
#include "study/experiment.hpp"

namespace alate::zhou2020 {

inline constexpr std::size_t kSets = 2;
inline constexpr std::uint64_t kSeeds = 20;

/// Problem 1: straight legs. Problem 2: a least turning radius. Problem 3: corrections that may fail.
enum class Task { straight, turning, unreliable };

/// 1, 2 or 3.
int number_of(Task task);

/// One route, or only its figures, as somebody published it.
struct PublishedRoute {
  std::string id;
  std::string source;
  Task task = Task::straight;
  std::size_t set = 0;  ///< Index of the set, 0 or 1.
  double length_m = 0;
  double rounding_m = 0;           ///< Half of the last digit printed.
  std::optional<int> corrections;  ///< Nothing where none is printed.
  std::optional<double> probability;
  std::vector<int> points;  ///< Empty where the route is not printed.
  int id_offset = 0;        ///< Added to the printed ids: another reading of them.
  std::string method;       ///< Our method that does the same; empty: none.
};

/// Every row of the claims, in the order of the tables they come from.
const std::vector<PublishedRoute>& published_routes();

/// "set 1".
std::string set_name(std::size_t set);

/// "set 1, problem 2".
std::string case_name(std::size_t set, Task task);

/// The contest's parameters with the points of `file`.
Scenario scenario_of(std::size_t set, Task task, const std::string& file);

}  // namespace alate::zhou2020
