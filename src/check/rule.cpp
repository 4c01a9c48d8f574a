#include "check/rule.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

void RuleReport::add(Finding finding) {
  if (!std::isfinite(finding.margin)) finding.value = finding.margin = -kUnbounded;
  const bool same_leg = !findings_.empty() && findings_.back().leg == finding.leg;
  if (!same_leg) {
    findings_.push_back(std::move(finding));
  } else if (finding.margin < findings_.back().margin) {
    findings_.back() = std::move(finding);
  }
}

namespace {

bool is_broken(const Finding& finding) {
  return finding.strict ? finding.margin <= 0 : finding.margin < -kRoundingNoise;
}

}  // namespace

void RuleReport::enter(Verdict& verdict) const {
  for (const Finding& f : findings_) {
    if (is_broken(f)) verdict.violations.push_back({rule_, f.leg, f.where, f.value, f.limit, f.unit});
  }
  const auto worst = std::ranges::min_element(findings_, {}, &Finding::margin);
  if (worst != findings_.end()) {
    verdict.margins.push_back({rule_, worst->margin, worst->unit, worst->leg, worst->where});
  }
  if (not_checked_) verdict.not_checked.push_back(*not_checked_);
}

}  // namespace alate
