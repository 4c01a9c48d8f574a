#include <algorithm>
#include <cmath>

#include "study/matrix/views.hpp"
#include "study/page/convergence_view.hpp"

namespace alate {

namespace {

constexpr double kLeastPercent = 0.01;  ///< A cost at the yardstick has no logarithm.
constexpr std::size_t kPoints = 48;

/// Best cost after `iteration`; nothing before the first route. A run that ended early keeps its last.
std::optional<double> best_after(const StudyRecord& record, std::uint64_t iteration) {
  const auto next =
      std::ranges::upper_bound(record.improvements, iteration, {}, &std::pair<std::uint64_t, double>::first);
  return next == record.improvements.begin() ? std::nullopt : std::optional(std::prev(next)->second);
}

/// Does the run tell its history in the costs that count?
bool tells_costs(const StudyRecord& record) {
  constexpr double kRelative = 1e-3;  // Ants may sum in single precision.
  return !record.improvements.empty() &&
         std::abs(record.improvements.back().second - record.cost) <= kRelative * record.cost;
}

/// Nothing until every run that ends with a route has one.
std::optional<Convergence::Point> point_at(const MethodFigures& method, std::uint64_t iteration) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < method.records.size(); ++i) {
    if (!method.records[i]->valid || method.bases[i] <= 0) continue;
    const auto cost = best_after(*method.records[i], iteration);
    if (!cost) return std::nullopt;
    gaps.push_back(std::max(kLeastPercent, 100 * (*cost - method.bases[i]) / method.bases[i]));
  }
  const auto spread = spread_of(std::move(gaps));
  if (!spread) return std::nullopt;
  return Convergence::Point{.at = static_cast<double>(iteration),
                            .best = spread->median,
                            .least = spread->lower_quartile,
                            .greatest = spread->upper_quartile};
}

Convergence bands(const MethodFigures& method) {
  Convergence line{.css_class = line_class(method), .points = {}};
  std::uint64_t last = 0;
  for (const StudyRecord* record : method.records) {
    last = std::max(last, record->iterations);
  }
  std::uint64_t before = 0;
  for (std::size_t i = 0; i <= kPoints && last > 0; ++i) {
    const double share = static_cast<double>(i) / kPoints;
    const auto iteration = static_cast<std::uint64_t>(std::lround(std::pow(static_cast<double>(last), share)));
    if (iteration == before) continue;
    before = iteration;
    if (const auto point = point_at(method, iteration)) line.points.push_back(*point);
  }
  return line;
}

}  // namespace

bool has_bands(const MethodFigures& method) {
  return std::ranges::all_of(method.records, [](const auto* each) { return !each->valid || tells_costs(*each); });
}

std::string bands_svg(const Study& study, const StudyAnalysis& analysis, std::size_t budget) {
  std::vector<Convergence> lines;
  for (const MethodFigures& method : analysis.methods) {
    if (method.budget != budget || method.planner >= kLineStyles || !has_bands(method)) continue;
    Convergence line = bands(method);
    if (line.points.size() > 1) lines.push_back(std::move(line));
  }
  if (lines.empty()) return {};
  return convergence_svg(lines, percent_range({lines}), "Convergence, " + study.budgets[budget].text());
}

}  // namespace alate
