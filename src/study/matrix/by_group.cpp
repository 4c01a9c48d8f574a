#include "study/matrix/by_group.hpp"

#include <algorithm>
#include <optional>

#include "study/matrix/study_parts.hpp"

namespace alate {

namespace {

/// Where each of `count` items goes once those that are not kept are gone.
template <class Keep>
std::vector<std::optional<std::size_t>> places_of(std::size_t count, const Keep& keep) {
  std::vector<std::optional<std::size_t>> places(count);
  std::size_t next = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (keep(i)) places[i] = next++;
  return places;
}

StudyPart part_of(const Study& study, const StudyRecords& records, std::size_t group) {
  StudyPart part{.name = study.groups[group],
                 .study = {.file = study.file,
                           .groups = {study.groups[group]},
                           .references = study.references,
                           .budgets = study.budgets,
                           .fingerprint = study.fingerprint}};
  const auto refusal = [&](std::size_t planner) {
    return std::ranges::find_if(study.refusals,
                                [&](const StudyRefusal& r) { return r.group == group && r.planner == planner; });
  };
  const auto scenarios =
      places_of(study.scenarios.size(), [&](std::size_t s) { return study.scenarios[s].group == group; });
  const auto planners =
      places_of(study.planners.size(), [&](std::size_t p) { return refusal(p) == study.refusals.end(); });
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    if (!scenarios[s]) continue;
    part.study.scenarios.push_back(study.scenarios[s]);
    part.study.scenarios.back().group = 0;
  }
  for (std::size_t p = 0; p < planners.size(); ++p) {
    if (planners[p])
      part.study.planners.push_back(study.planners[p]);
    else
      part.refused.emplace_back(label_of(study.planners[p]), refusal(p)->why);
  }
  for (std::size_t i = 0; i < study.jobs.size(); ++i) {
    StudyJob job = study.jobs[i];
    if (!scenarios[job.scenario]) continue;
    job.scenario = *scenarios[job.scenario];
    if (!job.reference) job.planner = planners[job.planner].value();
    part.study.jobs.push_back(job);
    part.records.push_back(records[i]);
  }
  return part;
}

}  // namespace

std::vector<StudyPart> parts_of(const Study& study, const StudyRecords& records) {
  std::vector<StudyPart> parts;
  for (std::size_t group = 0; group < study.groups.size(); ++group) parts.push_back(part_of(study, records, group));
  return parts;
}

}  // namespace alate
