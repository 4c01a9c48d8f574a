#include "space/error_cases.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace alate {

namespace {

auto order_of(const ErrorCase& one) { return std::tie(one.error.vertical, one.error.horizontal); }

/// Sums probabilities of equal errors from `first` on; bits are equal where histories agree since the last resets.
void merge_equal(std::vector<ErrorCase>& cases, std::size_t first) {
  const auto begin = cases.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, cases.end(), [](const ErrorCase& a, const ErrorCase& b) { return order_of(a) < order_of(b); });
  auto last = begin;
  for (auto next = begin; next != cases.end(); ++next) {
    if (next == begin) continue;
    if (order_of(*next) == order_of(*last))
      last->probability += next->probability;
    else
      *++last = *next;
  }
  if (begin != cases.end()) cases.erase(last + 1, cases.end());
}

}  // namespace

void fly_cases(const Navigation& navigation, std::span<const ErrorCase> before, const CorrectionLeg& leg,
               std::vector<ErrorCase>& after) {
  const std::size_t first = after.size();
  for (const ErrorCase& one : before) {
    const NavigationError error = grown(navigation, one.error, leg.length_m);
    if (!keeps_limits(navigation, error, leg.kind)) continue;
    const double success = leg.kind == PointKind::end ? 1 : leg.success;
    if (success > 0) after.push_back({corrected(error, leg.kind), one.probability * success});
    if (success < 1) after.push_back({failed(navigation, error, leg.kind), one.probability * (1 - success)});
  }
  merge_equal(after, first);
}

double total_probability(std::span<const ErrorCase> cases) {
  return std::accumulate(cases.begin(), cases.end(), 0.0,
                         [](double sum, const ErrorCase& one) { return sum + one.probability; });
}

double success_probability(const Navigation& navigation, std::span<const CorrectionLeg> legs) {
  std::vector<ErrorCase> cases{{}};
  std::vector<ErrorCase> next;
  for (const CorrectionLeg& leg : legs) {
    next.clear();
    fly_cases(navigation, cases, leg, next);
    cases.swap(next);
  }
  return std::min(1.0, total_probability(cases));
}

double success_probability(const Navigation& navigation, const Vec3& start, const Vec3& goal,
                           std::span<const CorrectionPoint> points) {
  std::vector<CorrectionLeg> legs;
  Vec3 at = start;
  for (const CorrectionPoint& point : points) {
    legs.push_back({.length_m = (point.position - at).norm(), .kind = point.kind, .success = point.success});
    at = point.position;
  }
  legs.push_back({.length_m = (goal - at).norm(), .kind = PointKind::end, .success = 1});
  return success_probability(navigation, legs);
}

}  // namespace alate
