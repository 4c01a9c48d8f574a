// All runs of the reproduction: the exact fronts of every problem, and every method on problem 1.
#pragma once

#include <filesystem>

#include "study/zhou2020/paper.hpp"

namespace alate::zhou2020 {

/// Where a point set lies; throws InputError naming every file that is missing.
std::array<std::string, kSets> find_sets(const std::string& folder);

struct Study {
  Experiment exact;    ///< label-setting with its whole front: case 3 * set + task.
  Experiment methods;  ///< Every planner on problem 1: case = set.

  static std::size_t case_of(std::size_t set, Task task) { return 3 * set + static_cast<std::size_t>(task); }
  const Site& site(std::size_t set, Task task) const { return exact.cases[case_of(set, task)].site(); }
  /// A method's runs on problem 1 of a set.
  const Trial& trial(std::size_t set, std::string_view method) const {
    return methods.at(set, method_index(methods, method));
  }
  /// What label-setting proved.
  const Plan& proven(std::size_t set, Task task) const;
};

/// Nothing run yet. Throws InputError if a set is missing or wrong.
Study plan_study(const ReproduceOptions& options);

/// Length of the shortest route of the front that needs no more corrections and is no less likely to succeed; nothing
/// where there is none.
std::optional<double> least_length(const Plan& proven, std::optional<int> corrections,
                                   std::optional<double> probability);

/// Names of methods that claims and tables refer to.
inline constexpr const char* kExact = "label-setting";
inline constexpr const char* kImproved = "correction-ga, improved";
inline constexpr const char* kPaperGa = "genetic algorithm, adaptive rates";
inline constexpr const char* kPlainGa = "genetic algorithm, constant rates";
inline constexpr const char* kCorrectedAstar = "sparse A*, corrected";
inline constexpr const char* kAstar1 = "improved A*, weights 1";
inline constexpr const char* kAstar2 = "improved A*, weights 2";
inline constexpr const char* kPlainAstar1 = "plain A*, weights 1";
inline constexpr const char* kPlainAstar2 = "plain A*, weights 2";
inline constexpr const char* kAnts = "correction-aco, MAX-MIN";
inline constexpr const char* kAntSystem = "correction-aco, Ant System";

}  // namespace alate::zhou2020
