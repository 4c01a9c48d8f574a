#include "check/success_chance.hpp"

#include <algorithm>

#include "alate/check/check.hpp"

namespace alate {

namespace {

constexpr std::size_t kMostPairs = 20'000'000;

struct Outcome {
  Errors errors;
  double chance = 1;
};

bool keeps_limits(const Navigation& navigation, const Errors& errors, const Visit& visit, bool last) {
  if (visit.point != nullptr) {
    const Navigation::Limits& most = limits_at(navigation, visit.point->kind);
    if (errors.vertical > most.vertical + kRoundingNoise || errors.horizontal > most.horizontal + kRoundingNoise)
      return false;
  }
  return !last || (errors.vertical < navigation.theta && errors.horizontal < navigation.theta);
}

/// Pairs of the same errors become one.
void merge(std::vector<Outcome>& outcomes) {
  std::ranges::sort(outcomes, {}, &Outcome::errors);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < outcomes.size(); ++i) {
    if (outcomes[i].errors == outcomes[kept].errors) {
      outcomes[kept].chance += outcomes[i].chance;
    } else {
      outcomes[++kept] = outcomes[i];
    }
  }
  outcomes.resize(std::min(outcomes.size(), kept + 1));
}

/// Both ways a correction can go.
std::vector<Outcome> after_correction(const Navigation& navigation, const std::vector<Outcome>& before,
                                      const CorrectionPoint& point) {
  std::vector<Outcome> after;
  for (const auto& [errors, chance] : before) {
    if (point.success > 0) after.push_back({corrected(errors, point.kind), chance * point.success});
    if (point.success < 1) after.push_back({uncorrected(navigation, errors, point.kind), chance * (1 - point.success)});
  }
  merge(after);
  return after;
}

}  // namespace

std::optional<double> success_chance(const Navigation& navigation, std::span<const Visit> visits) {
  std::vector<Outcome> alive{{}};
  double lost = 0;
  std::size_t pairs = 0;
  for (const Visit& visit : visits) {
    const bool last = &visit == &visits.back();
    for (Outcome& outcome : alive) outcome.errors = grown(navigation, outcome.errors, visit.length_m);
    std::erase_if(alive, [&](const Outcome& outcome) {
      const bool dies = !keeps_limits(navigation, outcome.errors, visit, last);
      if (dies) lost += outcome.chance;
      return dies;
    });
    if (alive.empty()) return 0;
    pairs += alive.size();
    if (pairs > kMostPairs) return std::nullopt;
    if (visit.point != nullptr) alive = after_correction(navigation, alive, *visit.point);
  }
  return std::max(0.0, 1 - lost);
}

}  // namespace alate
