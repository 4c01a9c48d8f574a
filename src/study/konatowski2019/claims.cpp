#include "study/konatowski2019/claims.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/konatowski2019/number_claims.hpp"

namespace alate::konatowski2019 {

namespace {

/// All weights sum to 1, so the cost of one route is linear in the fuel weight: the middle is the mean of the outer
/// two.
Claim one_initial_route() {
  const auto& [low, middle, high] = kPublished;
  const double expected = (low.initial + high.initial) / 2;
  const double off = std::abs(expected - middle.initial);
  const bool same = off <= 2 * kPublishedRounding;
  return {
      .id = "one-initial-route",
      .text = "The three initial costs are one base route, priced under three weight pairs",
      .published = middle.initial,
      .ours = expected,
      .unit = "",
      .verdict = same ? ClaimVerdict::holds : ClaimVerdict::does_not_hold,
      .why = fmt::format("The weights sum to 1, so the cost of one route is linear in the fuel weight, and the cost "
                         "at 0.5 must be the mean of the other two, {:.2f}. Printed is {:.2f}: off by {:.2f}, where "
                         "rounding allows {:.2f}. Nearly one route, but not one.",
                         expected, middle.initial, off, 2 * kPublishedRounding)};
}

/// The best cost is a minimum of functions linear in the fuel weight, so it is concave in it.
Claim best_costs_agree() {
  const auto& [low, middle, high] = kPublished;
  const double least = (low.best + high.best) / 2;
  const bool concave = middle.best >= least - 2 * kPublishedRounding;
  return {
      .id = "best-costs-agree",
      .text = "The three best costs can all be the best of one layout",
      .published = middle.best,
      .ours = least,
      .unit = "",
      .verdict = concave ? ClaimVerdict::holds : ClaimVerdict::impossible,
      .why = fmt::format("Each route's cost is linear in the fuel weight, so the least cost is concave in it: at 0.5 "
                         "it is at least the mean of the other two, {:.2f}. {:.2f} {} that.",
                         least, middle.best, concave ? "keeps" : "breaks")};
}

Claim gain_arithmetic() {
  double worst = 0;
  std::string parts;
  for (const Published& row : kPublished) {
    const double gain = gain_percent(row.initial, row.best);
    worst = std::max(worst, std::abs(gain - row.gain_percent));
    parts += fmt::format("{}{:.2f} % against {:.1f} %", parts.empty() ? "" : ", ", gain, row.gain_percent);
  }
  const bool right = worst <= kGainRounding;
  return {
      .id = "gain-arithmetic",
      .text = "The stated gains follow from the stated costs",
      .published = kGainRounding,
      .ours = worst,
      .unit = "points",
      .verdict = right ? ClaimVerdict::holds : ClaimVerdict::does_not_hold,
      .why = fmt::format("Recomputed from initial and best cost: {}. The largest difference is {:.2f} points; rounding "
                         "allows {:.2f}.",
                         parts, worst, kGainRounding)};
}

struct GainTrend {
  const char* id;
  const char* whose;
  GainsByRow (*gains)(const Study&, std::size_t layout);
};

/// Holds where the gain over the base route falls from row to row on every layout.
Claim gain_falls(const Study& study, const GainTrend& trend) {
  Claim claim{.id = trend.id,
              .text = fmt::format("The gain falls as the fuel weight rises ({})", trend.whose),
              .published = {},
              .ours = {},
              .unit = "",
              .why = "Gain over the base route at fuel weights 0.2, 0.5 and 0.8, in percent."};
  bool all = true;
  for (std::size_t l = 0; l < layouts().size(); ++l) {
    const auto [low, middle, high] = trend.gains(study, l);
    if (!low || !middle || !high) {
      claim.why = "Some runs found no route.";
      return claim;
    }
    claim.why += fmt::format(" {}: {:.1f}, {:.1f}, {:.1f}.", layouts()[l].name, *low, *middle, *high);
    all = all && *low > *middle && *middle > *high;
  }
  claim.verdict = all ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  claim.why += all ? " It falls on every layout." : " It does not fall on every layout.";
  return claim;
}

/// The paper's best cost for fuel 0.8 against the paper's own method where nothing but fuel costs anything.
Claim reach_without_threats(const Study& study) {
  std::vector<double> costs;
  for (const char* name : {kLiteral20, kLiteral, kLiteral100}) {
    const auto of_method = study.open.at(0, method_index(study.open, name)).costs();
    costs.insert(costs.end(), of_method.begin(), of_method.end());
  }
  const double published = kPublished.back().best;
  const auto reached = std::ranges::count_if(costs, [&](double cost) { return cost <= published; });
  const auto summary = summarize(costs);
  Claim claim{.id = "best-0.8-in-open-air",
              .text = "The printed rule reaches the best cost printed for fuel 0.8",
              .published = published,
              .ours = summary ? std::optional(summary->least) : std::nullopt,
              .unit = "",
              .why = "No run found a route."};
  if (!summary) return claim;
  claim.verdict = reached > 0 ? ClaimVerdict::cannot_be_told : ClaimVerdict::does_not_hold;
  claim.why = fmt::format(
      "Tried without any threat, where every route is cheaper than among threats: {} of {} runs with 20, 50 and 100 "
      "ants "
      "reached it; the best came to {:.2f}, the mean to {:.2f}.",
      reached, costs.size(), summary->least, summary->mean);
  claim.why += reached > 0 ? " With the authors' threats it may or may not be reached."
                           : " So the authors' program differs from the printed rule, or had another colony or stop "
                             "rule. This is evidence from runs, not a proof.";
  return claim;
}

struct Rivals {
  const char* id;
  const char* text;
  const char* first;
  const char* second;
};

/// Holds where the first has the lower mean in more than half of the cells, and over all.
Claim rivalry(const Study& study, const Rivals& rivals) {
  const Duel result = duel(study, rivals.first, rivals.second);
  const bool better = 2 * result.won > result.cells && result.saving_percent > 0;
  Claim claim{
      .id = rivals.id, .text = rivals.text, .published = {}, .ours = {}, .unit = "%", .why = "No routes found."};
  if (result.cells == 0) return claim;
  claim.ours = result.saving_percent;
  claim.verdict = better ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  claim.why = fmt::format(
      "With as many walks, {} has the lower mean cost than {} in {} of {} cells; over all cells its "
      "mean is {:.2f} % {}.",
      rivals.first, rivals.second, result.won, result.cells, std::abs(result.saving_percent),
      result.saving_percent >= 0 ? "lower" : "higher");
  return claim;
}

}  // namespace

std::vector<Claim> claims(const Study& study) {
  std::vector<Claim> all;
  for (std::size_t row = 0; row < kPublished.size(); ++row)
    for (const auto& claim_of : {initial_cost, best_cost, gain_over_base}) all.push_back(claim_of(study, row));
  all.push_back(gain_arithmetic());
  all.push_back(one_initial_route());
  all.push_back(best_costs_agree());
  all.push_back(gain_falls(study, {"gain-falls", "best routes of any method", gains_of_best_routes}));
  all.push_back(gain_falls(study, {"gain-falls-ants", kLiteral, gains_of_literal}));
  for (std::size_t row = 0; row < kPublished.size(); ++row) all.push_back(gain_of_ants(study, row));
  all.push_back(reach_without_threats(study));
  constexpr std::array<Rivals, 3> kRivals{
      {{"pheromone-helps", "Pheromone leads the ants to cheaper routes", kLiteral, kNoPheromone},
       {"next-step-rank", "A rank-based colony, a named next step, does better", kRank, kLiteral},
       {"next-step-mmas", "A MAX-MIN colony, a named next step, does better", kMaxMin, kLiteral}}};
  for (const Rivals& rivals : kRivals) all.push_back(rivalry(study, rivals));
  return all;
}

}  // namespace alate::konatowski2019
