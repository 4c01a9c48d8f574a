// alate study: planners tried on scenarios over seeds and budgets.
#include "alate/study/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "folder.hpp"
#include "interrupt.hpp"
#include "progress_bar.hpp"
#include "ranks.hpp"

namespace alate::cli {

namespace {

/// The command line as written.
struct StudyLine {
  Text study, threads, out;
};

/// What the other ranks find out is the same, so only the first speaks.
void keep_quiet() {
  for (std::FILE* stream : {stdout, stderr})
    if (std::freopen("/dev/null", "w", stream) == nullptr) std::fclose(stream);
}

struct Setting {
  Study study;
  std::string folder;
  int threads = 1;
};

Setting read_setting(const StudyLine& line, const Ranks& ranks, FaultList& faults) {
  const std::string file = read_required("STUDY", line.study, faults);
  const bool several = ranks.count() > 1;
  const int threads = several && !line.threads ? 1 : read_threads(line.threads, faults);
  if (line.out) check_folder(*line.out, faults);
  if (several && !line.out)
    faults.add({.file = "--out", .message = "is needed under mpirun: the ranks share a folder"});
  if (several && file == "-")
    faults.add({.file = "STUDY", .message = "standard input reaches one rank only; name a file"});
  auto study =
      file.empty() || (several && file == "-") ? std::nullopt : faults.collect([&] { return load_study(file); });
  faults.throw_if_any();
  return {.study = std::move(*study), .folder = line.out.value_or(""), .threads = threads};
}

/// What the rank is handed out. False if stopped, by any rank.
bool run_share(const Setting& setting, StudyRecords& records, const Ranks& ranks, const Interrupt& interrupt) {
  ProgressBar bar("run");
  Executor executor(setting.threads);
  SharedCounter counter(ranks);
  const StudyOptions options{.folder = setting.folder,
                             .rank = ranks.rank(),
                             .next = [&counter] { return counter.next(); },
                             .stop = interrupt.token(),
                             .on_progress = [&bar](const Progress& progress) { bar.draw(progress); }};
  try {
    return run_study(setting.study, records, executor, options);
  } catch (const std::exception& error) {
    if (ranks.count() > 1) fmt::print(stderr, "alate: {}\n", error.what());
    ranks.abort(kInternalFault);  // The others would wait for ever.
    throw;
  }
}

int tell_interrupted(const Setting& setting, const StudyRecords& records) {
  const auto done = std::ranges::count_if(records, [](const auto& record) { return record.has_value(); });
  fmt::print(stderr, "alate: interrupted after {} of {} runs; {}\n", done, records.size(),
             setting.folder.empty() ? "nothing was kept" : "the same command goes on with the rest");
  return kInterrupted;
}

/// Only the first rank holds the lock; every rank throws if it cannot.
std::unique_ptr<StudyFolder> open_folder(const Setting& setting, const Ranks& ranks) {
  std::unique_ptr<StudyFolder> folder;
  try {
    if (ranks.first() && !setting.folder.empty()) folder = std::make_unique<StudyFolder>(setting.folder);
  } catch (...) {
    ranks.all(false);
    throw;
  }
  if (!ranks.all(true)) throw InputError(Fault{.field = "--out", .message = "the first rank cannot take the folder"});
  return folder;
}

int study(const StudyLine& line, FaultList faults) {
  const Interrupt interrupt;  // Before any other thread.
  const Ranks ranks;
  if (!ranks.first()) keep_quiet();
  const Setting setting = read_setting(line, ranks, faults);
  const auto folder = open_folder(setting, ranks);
  StudyRecords records = read_journals(setting.study, setting.folder);
  ranks.all(true);  // No one writes before everyone has read.

  const bool whole = ranks.all(run_share(setting, records, ranks, interrupt));
  if (!setting.folder.empty() && ranks.count() > 1) records = read_journals(setting.study, setting.folder);
  if (!whole) return tell_interrupted(setting, records);
  if (!ranks.first()) return kDone;
  fmt::print("{}", to_text(setting.study, records));
  if (!folder) return kDone;
  fmt::print("\nFiles, the page first:\n");
  for (const std::string& name : folder->write(setting.study, records))
    fmt::print("  {}\n", (std::filesystem::path(setting.folder) / name).string());
  return kDone;
}

}  // namespace

void add_study(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<StudyLine>();
  CLI::App& command = *add_command(app, "study", "Compare planners over scenarios, seeds and budgets",
                                   "alate study studies/small.yaml --out out/small");
  add_text(command, "STUDY", line->study, "study file (YAML or JSON); - reads standard input");
  add_text(
      command, "--out", line->out,
      "folder for study.html, summary.md, rows.csv, times.csv and the journal, from which the same command goes on");
  add_text(command, "--threads", line->threads,
           "threads, 1 to 1024 a process (default: one a processor, under mpirun 1); changes times only");
  command.callback([&chosen, line] { chosen = [line](FaultList faults) { return study(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
