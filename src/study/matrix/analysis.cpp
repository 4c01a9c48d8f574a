#include "study/matrix/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "study/matrix/optimum.hpp"
#include "study/matrix/study_parts.hpp"
#include "study/paired_test.hpp"

namespace alate {

namespace {

/// With fewer, a test over scenarios has no power.
constexpr std::size_t kLeastScenarios = 6;

class Analyst {
 public:
  Analyst(const Study& study, const StudyRecords& records) : study_(study), records_(records), optima_(study, records) {
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (!records[i] || !records[i]->valid) continue;
      const auto [best, is_new] = best_.emplace(study.jobs[i].scenario, records[i]->cost);
      best->second = std::min(best->second, records[i]->cost);
    }
  }

  StudyAnalysis analyse() {
    analysis_.yardstick = choose_yardstick();
    for (std::size_t b = 0; b < study_.budgets.size(); ++b)
      for (std::size_t p = 0; p < study_.planners.size(); ++p) analysis_.methods.push_back(figures(p, b));
    analysis_.by_scenario = study_.scenarios.size() >= kLeastScenarios;
    add_duels();
    return std::move(analysis_);
  }

 private:
  /// The best yardstick that every scenario with a route has.
  Yardstick choose_yardstick() const {
    Yardstick yardstick = Yardstick::optimum;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      if (!records_[i] || !records_[i]->valid || study_.jobs[i].reference) continue;
      if (yardstick == Yardstick::optimum && optima_.of(study_.jobs[i]).value_or(0) <= 0)
        yardstick = Yardstick::lower_bound;
      if (records_[i]->lower_bound <= 0 && yardstick == Yardstick::lower_bound) return Yardstick::best_found;
    }
    return yardstick;
  }

  double base_of(std::size_t i) const {
    const auto best = best_.find(study_.jobs[i].scenario);
    if (analysis_.yardstick == Yardstick::optimum) return optima_.of(study_.jobs[i]).value_or(0);
    if (analysis_.yardstick == Yardstick::lower_bound) return records_[i]->lower_bound;
    return best == best_.end() ? 0 : best->second;
  }

  MethodFigures figures(std::size_t planner, std::size_t budget) const {
    MethodFigures method{.planner = planner, .budget = budget, .name = label_of(study_.planners[planner])};
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const StudyJob& job = study_.jobs[i];
      if (!records_[i] || job.reference || job.planner != planner || job.budget != budget) continue;
      const double base = base_of(i);
      ++method.runs;
      method.mean_s += records_[i]->wall_s;
      method.records.push_back(&*records_[i]);
      method.bases.push_back(base);
      if (records_[i]->valid && base > 0) method.gaps.push_back(100 * (records_[i]->cost - base) / base);
    }
    if (method.runs > 0) method.mean_s /= static_cast<double>(method.runs);
    method.gap = summarize(method.gaps);
    method.gap_margin = mean_margin(method.gaps);
    return method;
  }

  /// Costs of a method's units: a run without a valid route costs more than any.
  std::vector<double> units(const MethodFigures& method, std::size_t seeds) const {
    std::vector<double> costs;
    const std::size_t own = method.runs / study_.scenarios.size();
    for (std::size_t s = 0; s < study_.scenarios.size(); ++s) {
      std::vector<double> of_seeds;
      for (std::size_t i = 0; i < own; ++i) {
        const StudyRecord& record = *method.records[s * own + i];
        of_seeds.push_back(record.valid ? record.cost : std::numeric_limits<double>::infinity());
      }
      if (analysis_.by_scenario) {
        costs.push_back(lower_median(std::move(of_seeds)));
      } else {
        for (std::size_t i = 0; i < seeds; ++i) costs.push_back(of_seeds[own == 1 ? 0 : i]);
      }
    }
    return costs;
  }

  MethodDuel duel(std::size_t first, std::size_t second) const {
    const MethodFigures& a = analysis_.methods[first];
    const MethodFigures& b = analysis_.methods[second];
    const std::size_t seeds = std::max(a.runs, b.runs) / study_.scenarios.size();
    const std::vector<double> of_a = units(a, seeds);
    const std::vector<double> of_b = units(b, seeds);
    MethodDuel duel{.first = first, .second = second, .pairs = of_a.size()};
    std::vector<double> differences;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      if (of_a[i] < of_b[i]) ++duel.first_better;
      if (of_b[i] < of_a[i]) ++duel.second_better;
      differences.push_back(relative(of_a[i], of_b[i]));
    }
    const SignedRank test = signed_rank(differences);
    duel.p = test.p;
    duel.first_ahead = test.below;
    return duel;
  }

  /// Difference as a share of both, so that long routes weigh no more than short ones.
  static double relative(double a, double b) {
    if (a == b) return 0;
    if (std::isinf(a) || std::isinf(b)) return std::isinf(a) ? 1 : -1;
    return (a - b) / (std::abs(a) + std::abs(b));
  }

  void add_duels() {
    const std::size_t planners = study_.planners.size();
    for (std::size_t b = 0; b < study_.budgets.size(); ++b)
      for (std::size_t i = 0; i < planners; ++i)
        for (std::size_t j = i + 1; j < planners; ++j)
          analysis_.duels.push_back(duel(b * planners + i, b * planners + j));
    std::vector<double> chances;
    for (const MethodDuel& each : analysis_.duels) chances.push_back(each.p);
    const std::vector<double> corrected = holm(chances);
    for (std::size_t i = 0; i < corrected.size(); ++i) analysis_.duels[i].corrected = corrected[i];
  }

  const Study& study_;
  const StudyRecords& records_;
  Optima optima_;
  std::map<std::size_t, double> best_;
  StudyAnalysis analysis_;
};

}  // namespace

const char* words_of(Yardstick yardstick) {
  switch (yardstick) {
    case Yardstick::optimum:
      return "the optimum";
    case Yardstick::lower_bound:
      return "the lower bound";
    case Yardstick::best_found:
      break;
  }
  return "the best route found";
}

StudyAnalysis analyse(const Study& study, const StudyRecords& records) { return Analyst(study, records).analyse(); }

std::string full_name(const Study& study, const MethodFigures& method) {
  return study.budgets.size() == 1 ? method.name : method.name + ", " + study.budgets[method.budget].text();
}

}  // namespace alate
