#include "study/matrix/optimum.hpp"

namespace alate {

Optima::Optima(const Study& study, const StudyRecords& records) : study_(study) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& record = records[i];
    if (!record || record->outcome != Outcome::optimal || !record->valid) continue;
    const StudyJob& job = study.jobs[i];
    const auto& planners = job.reference ? study.references : study.planners;
    proved_.emplace(std::pair(job.scenario, space_of(planners[job.planner], job)), record->cost);
  }
}

std::string Optima::space_of(const StudyPlanner& planner, const StudyJob& job) const {
  return planner.can_on(study_.scenarios[job.scenario].world.site()).space;
}

std::optional<double> Optima::of(const StudyJob& job) const {
  const auto found = proved_.find({job.scenario, space_of(study_.planners[job.planner], job)});
  return found == proved_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> gap_of(const StudyRecord& record, const std::optional<double>& optimum) {
  const double base = optimum.value_or(record.lower_bound);
  if (!record.has_route() || base <= 0) return std::nullopt;
  return (record.cost - base) / base;
}

}  // namespace alate
