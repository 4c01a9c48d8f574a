#include "study/matrix/optimum.hpp"

namespace alate {

Optima::Optima(const Study& study, const StudyRecords& records) : study_(study) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& record = records[i];
    if (!record || record->outcome != Outcome::optimal || !record->valid) continue;
    const StudyJob& job = study.jobs[i];
    const auto& planners = job.reference ? study.references : study.planners;
    proved_.emplace(std::pair(job.scenario, planners[job.planner].space), record->cost);
  }
}

std::optional<double> Optima::of(const StudyJob& job) const {
  const auto found = proved_.find({job.scenario, study_.planners[job.planner].space});
  return found == proved_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> gap_of(const StudyRecord& record, const std::optional<double>& optimum) {
  const double base = optimum.value_or(record.lower_bound);
  if (!record.has_route() || base <= 0) return std::nullopt;
  return (record.cost - base) / base;
}

}  // namespace alate
