#include <memory>
#include <mutex>

#include "alate/study/study.hpp"
#include "study/matrix/journal.hpp"
#include "study/matrix/record.hpp"
#include "study/run_loop.hpp"

namespace alate {

namespace {

std::vector<std::size_t> without_record(const StudyRecords& records) {
  std::vector<std::size_t> left;
  for (std::size_t job = 0; job < records.size(); ++job)
    if (!records[job]) left.push_back(job);
  return left;
}

StudyRun run_job(const Study& study, const StudyJob& job, const std::stop_token& stop) {
  const Problem problem(study.scenarios[job.scenario].world);
  RunOptions options{.seed = job.seed, .stop = stop};
  if (!job.reference) {
    options.iterations = study.budgets[job.budget].iterations;
    options.time_limit_s = study.budgets[job.budget].time_s;
  }
  const auto& planners = job.reference ? study.references : study.planners;
  return run_once(planners[job.planner].planner, problem, std::move(options));
}

}  // namespace

bool run_study(const Study& study, StudyRecords& records, Executor& executor, const StudyOptions& options) {
  const std::vector<std::size_t> left = without_record(records);
  std::unique_ptr<Journal> journal;
  if (!options.folder.empty() && !left.empty())
    journal = std::make_unique<Journal>(options.folder, options.rank, study);
  std::mutex mutex;
  const auto run = [&](std::size_t i) {
    const StudyRun done = run_job(study, study.jobs[left[i]], options.stop);
    if (done.plan.stop == Stop::cancelled) return;
    records[left[i]] = record_of(done);
    const std::lock_guard lock(mutex);
    if (journal) journal->add(left[i], *records[left[i]]);
  };
  return run_all({.count = left.size(),
                  .run = run,
                  .next = options.next,
                  .stop = options.stop,
                  .on_progress = options.on_progress},
                 executor);
}

}  // namespace alate
