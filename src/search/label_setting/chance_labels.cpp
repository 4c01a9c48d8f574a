#include "search/label_setting/chance_labels.hpp"

#include <algorithm>
#include <limits>

namespace alate {

namespace {

/// Probability of errors of at most these.
double quadrant(std::span<const ErrorCase> cases, double vertical, double horizontal) {
  double sum = 0;
  for (const ErrorCase& one : cases)
    if (one.error.vertical <= vertical && one.error.horizontal <= horizontal) sum += one.probability;
  return sum;
}

}  // namespace

double ChanceLabels::least_error(const ChanceLabel& label, PointKind kind) const {
  double least = std::numeric_limits<double>::infinity();
  for (const ErrorCase& one : cases_of(label))
    least = std::min(least, kind == PointKind::vertical ? one.error.horizontal : one.error.vertical);
  return least;
}

ChanceLabel ChanceLabels::fly(const Navigation& navigation, std::uint32_t from, const CorrectionLeg& leg,
                              bool certain) {
  ChanceLabel next{.parent = from, .first_case = static_cast<std::uint32_t>(cases_.size())};
  before_.assign(1, ErrorCase{});
  if (from != kNoLabel) {
    const auto cases = cases_of(pool_[from]);
    before_.assign(cases.begin(), cases.end());
    next.length_m = pool_[from].length_m + leg.length_m;
    next.corrections = pool_[from].corrections + 1;
  }
  const double success = certain && leg.success < 1 ? 0 : leg.success;
  fly_cases(navigation, before_, {.length_m = leg.length_m, .kind = leg.kind, .success = success}, cases_);
  next.case_count = static_cast<std::uint32_t>(cases_.size()) - next.first_case;
  next.probability = total_probability(cases_of(next));
  return next;
}

bool ChanceLabels::keep(const ChanceLabel& label) {
  std::vector<std::uint32_t>& kept = kept_[label.node];
  if (std::ranges::any_of(kept, [&](std::uint32_t other) { return dominates(pool_[other], label); })) {
    forget(label);
    return false;
  }
  std::erase_if(kept, [&](std::uint32_t other) {
    if (!dominates(label, pool_[other])) return false;
    if (pool_[other].corrections == label.corrections) dominated_[other] = true;
    return true;
  });
  kept.push_back(size());
  pool_.push_back(label);
  dominated_.push_back(false);
  return true;
}

std::vector<CorrectionPoint> ChanceLabels::points_to(const CorrectionGraph& graph, std::uint32_t last) const {
  std::vector<CorrectionPoint> points;
  for (std::uint32_t at = last; at != kNoLabel; at = pool_[at].parent)
    if (pool_[at].node < graph.point_count()) points.push_back(graph.point(pool_[at].node));
  std::ranges::reverse(points);
  return points;
}

/// In length, probability and errors; corrections are the layers' business. Quadrants grow only at the errors of y's
/// own cases.
bool ChanceLabels::dominates(const ChanceLabel& x, const ChanceLabel& y) const {
  if (x.length_m > y.length_m || x.probability + kSameProbability < y.probability) return false;
  const auto cases_x = cases_of(x);
  const auto cases_y = cases_of(y);
  return std::ranges::all_of(cases_y, [&](const ErrorCase& v) {
    return std::ranges::all_of(cases_y, [&](const ErrorCase& h) {
      return quadrant(cases_x, v.error.vertical, h.error.horizontal) + kSameProbability >=
             quadrant(cases_y, v.error.vertical, h.error.horizontal);
    });
  });
}

}  // namespace alate
