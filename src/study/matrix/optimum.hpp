// What exact planners proved.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "alate/study/study.hpp"

namespace alate {

/// Least cost of a scenario on a search space, where a run, of the references or of the study, proved it.
class Optima {
 public:
  Optima(const Study& study, const StudyRecords& records);

  std::optional<double> of(const StudyJob& job) const;

 private:
  /// A planner of several spaces has one on each scenario.
  std::string space_of(const StudyPlanner& planner, const StudyJob& job) const;

  const Study& study_;
  std::map<std::pair<std::size_t, std::string>, double> proved_;
};

/// (cost - base) / base, where base is the optimum, or the lower bound where no optimum is known. Nothing without a
/// route or a base above zero.
std::optional<double> gap_of(const StudyRecord& record, const std::optional<double>& optimum);

}  // namespace alate
