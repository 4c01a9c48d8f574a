// A study in a few tables, for a page of documentation.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "alate/core/version.hpp"
#include "study/machine.hpp"
#include "study/matrix/by_group.hpp"
#include "study/matrix/study_parts.hpp"
#include "study/spread.hpp"

namespace alate {

namespace {

constexpr double kNear = 1;  ///< Percent.
constexpr double kNever = std::numeric_limits<double>::infinity();

/// The runs of one planner with one budget.
struct Cell {
  std::vector<double> gaps;  ///< Percent above the best known; without a valid route infinite.
  std::vector<double> times_s;
  std::size_t valid = 0;
};

std::string time_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.0f} µs", std::max(1.0, 1e6 * seconds));
  if (seconds < 1) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.2g} s", seconds);
}

std::string budget_text(const StudyBudget& budget) {
  if (budget.time_s && !budget.iterations) return time_text(*budget.time_s);
  return budget.text();
}

/// Never "-0.00".
std::string signed_text(double percent) { return fmt::format("{:+.2f}", std::abs(percent) < 0.005 ? 0 : percent); }

/// Safe between the bars of a table, and never a tag.
std::string markdown(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    if (std::string_view("\\|<>&*_`[]").find(c) != std::string_view::npos) shown += '\\';
    shown += c == '\n' ? ' ' : c;
  }
  return shown;
}

class Summary {
 public:
  explicit Summary(const StudyPart& part) : part_(part), cells_(part.study.planners.size()) {
    for (auto& row : cells_) row.resize(part.study.budgets.size());
    note_closed();
    note_best();
    for (std::size_t i = 0; i < part.records.size(); ++i)
      if (part.records[i] && !part.study.jobs[i].reference) count(part.study.jobs[i], *part.records[i]);
  }

  std::string text() const {
    std::string text = part_.name.empty() ? "" : fmt::format("### {}\n\n", markdown(part_.name));
    text += opening() + header();
    for (std::size_t p = 0; p < cells_.size(); ++p) text += row(p);
    return text + "\n";
  }

 private:
  /// Scenarios without any route, which is proven, tell planners apart by nothing.
  void note_closed() {
    for (std::size_t i = 0; i < part_.records.size(); ++i)
      if (part_.records[i] && part_.records[i]->outcome == Outcome::infeasible_proven)
        closed_.insert(part_.study.jobs[i].scenario);
  }

  /// The proven optimum of a scenario, the greatest where planners that move more freely prove a lower one; else the
  /// best route that any run found.
  void note_best() {
    for (const bool proven : {true, false}) {
      for (std::size_t i = 0; i < part_.records.size(); ++i) {
        const auto& record = part_.records[i];
        const std::size_t scenario = part_.study.jobs[i].scenario;
        if (!record || !record->valid || (proven ? record->outcome != Outcome::optimal : proven_.contains(scenario)))
          continue;
        const auto [best, is_new] = best_.emplace(scenario, record->cost);
        best->second = proven ? std::max(best->second, record->cost) : std::min(best->second, record->cost);
        if (proven) proven_.insert(scenario);
      }
    }
  }

  void count(const StudyJob& job, const StudyRecord& record) {
    seeds_.insert(job.seed);
    if (closed_.contains(job.scenario)) return;
    Cell& cell = cells_[job.planner][job.budget];
    const auto best = best_.find(job.scenario);
    const bool judged = record.valid && best != best_.end() && best->second > 0;
    cell.gaps.push_back(judged ? 100 * (record.cost - best->second) / best->second : kNever);
    cell.times_s.push_back(record.wall_s);
    cell.valid += record.valid ? 1U : 0U;
  }

  std::string opening() const {
    const auto counted = [](std::size_t count, const char* what) {
      return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    std::string text =
        fmt::format("{}, {}. ", counted(part_.study.scenarios.size(), "scenario"), counted(seeds_.size(), "seed"));
    if (!closed_.empty()) text += fmt::format("Left out as proven to have no route: {}. ", closed_.size());
    return text + fmt::format("Best known: the proven optimum of {}, else the best route of all runs.\n\n",
                              counted(proven_.size(), "scenario"));
  }

  std::string header() const {
    std::string text = "| planner |";
    std::string rule = "|---|";
    for (const StudyBudget& budget : part_.study.budgets) {
      text += fmt::format(" {} |", budget_text(budget));
      rule += "---:|";
    }
    return text + " within 1 % after |\n" + rule + "---:|\n";
  }

  std::string row(std::size_t planner) const {
    std::string text = fmt::format("| {} |", markdown(label_of(part_.study.planners[planner])));
    for (const Cell& cell : cells_[planner]) text += fmt::format(" {} |", gap_text(cell));
    return text + fmt::format(" {} |\n", near_text(planner));
  }

  /// The share of valid routes is told where it is not all.
  static std::string gap_text(const Cell& cell) {
    if (cell.gaps.empty()) return "";
    const double middle = lower_median(cell.gaps);
    std::string gap = middle < kNever ? signed_text(middle) : "–";
    if (cell.valid == cell.gaps.size()) return gap;
    const double share = 100 * static_cast<double>(cell.valid) / static_cast<double>(cell.gaps.size());
    return fmt::format("{} ({:.0f} % valid)", gap, share);
  }

  std::string near_text(std::size_t planner) const {
    double least = kNever;
    for (const Cell& cell : cells_[planner])
      if (lower_median(cell.gaps) <= kNear) least = std::min(least, lower_median(cell.times_s));
    return least < kNever ? time_text(least) : "–";
  }

  const StudyPart& part_;
  std::set<std::size_t> closed_;
  std::map<std::size_t, double> best_;  ///< By scenario.
  std::set<std::size_t> proven_;
  std::set<std::uint64_t> seeds_;
  std::vector<std::vector<Cell>> cells_;  ///< By planner, then budget.
};

}  // namespace

std::string summary_markdown(const Study& study, const StudyRecords& records) {
  const Machine machine = this_machine();
  std::string text = fmt::format(
      "Median cost of a planner's runs above the best known, percent, by budget; a run without a valid route counts as "
      "worse than any with one, and a dash says that more than half had none. Last column: the median planning time of "
      "the least budget whose median run lies within 1 % of the best known. alate {}, one thread a run, {}, {}.\n\n",
      version(), machine.processor, machine.compiler);
  for (const StudyPart& part : parts_of(study, records)) text += Summary(part).text();
  return text;
}

}  // namespace alate
