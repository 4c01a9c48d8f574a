// What a rule hands back: where each leg stands against its limit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/check/check.hpp"

namespace alate {

/// Stands for "no bound at all" in values that must stay finite, metres.
inline constexpr double kUnbounded = 1e9;

/// The worst place of one leg.
struct Finding {
  std::size_t leg = 0;
  Vec3 where = Vec3::Zero();
  double value = 0;
  double limit = 0;
  std::string unit = "m";
  double margin = 0;    ///< Set by RuleReport.
  bool strict = false;  ///< Set by RuleReport: no margin at all breaks the rule.
};

/// Collects the worst finding of every leg. Findings of one leg follow each other. A value that is
/// not finite counts as broken.
class RuleReport {
 public:
  explicit RuleReport(std::string rule) : rule_(std::move(rule)) {}

  void at_least(Finding finding) {
    finding.margin = finding.value - finding.limit;
    add(std::move(finding));
  }
  void at_most(Finding finding) {
    finding.margin = finding.limit - finding.value;
    add(std::move(finding));
  }
  /// Less than the limit, without slack.
  void below(Finding finding) {
    finding.strict = true;
    at_most(std::move(finding));
  }
  /// Says why the rule, or a part of the route, was not judged; the first reason stands.
  void not_checked(std::string why, bool unknown = false) {
    if (!not_checked_) not_checked_ = NotChecked{rule_, std::move(why), unknown};
  }

  /// Writes violations, the worst margin and what was not judged.
  void enter(Verdict& verdict) const;

 private:
  void add(Finding finding);

  std::string rule_;
  std::vector<Finding> findings_;
  std::optional<NotChecked> not_checked_;
};

}  // namespace alate
