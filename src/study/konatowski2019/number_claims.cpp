#include "study/konatowski2019/number_claims.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace alate::konatowski2019 {

namespace {

/// A figure for each layout, or nothing where there is none.
using OnLayout = std::function<std::optional<double>(std::size_t layout)>;

/// Fills `by_case` and, if every layout has a figure, `ours` with their mean.
void fill_ours(Claim& claim, std::size_t row, const OnLayout& figure) {
  std::vector<double> values;
  for (std::size_t l = 0; l < layouts().size(); ++l) {
    const auto value = figure(l);
    if (!value) continue;
    values.push_back(*value);
    claim.by_case.emplace_back(case_name(layouts()[l], kPublished[row]), *value);
  }
  if (values.size() == layouts().size()) claim.ours = summarize(values)->mean;
}

std::optional<double> base_cost(const Study& study, std::size_t layout, std::size_t row) {
  const Route* base = study.base_route();
  if (base == nullptr) return std::nullopt;
  return measure(study.main.cases[Study::case_of(layout, row)].site(), *base).cost;
}

std::optional<double> literal_mean(const Study& study, std::size_t layout, std::size_t row) {
  const auto summary = study.trial(layout, row, kLiteral).summary();
  return summary ? std::optional(summary->mean) : std::nullopt;
}

/// Bound of the sum of distances to go, for any threats.
double least_distance_sum(const Study& study) {
  return study.open.trials.front().runs.front().plan.lower_bound / kPublished.back().fuel;
}

std::string weights_of(const Published& row) { return fmt::format("fuel {:.1f}, threat {:.1f}", row.fuel, row.threat); }

constexpr const char* kNoFigure3 = "Figure 3, the paper's threats, is not available.";

}  // namespace

Claim initial_cost(const Study& study, std::size_t row) {
  const Published& published = kPublished[row];
  const double bound = published.fuel * least_distance_sum(study);
  const bool possible = published.initial >= bound - kPublishedRounding;
  Claim claim{.id = fmt::format("initial-{:.1f}", published.fuel),
              .text = "Initial cost at " + weights_of(published),
              .published = published.initial,
              .ours = {},
              .unit = "",
              .verdict = possible ? ClaimVerdict::cannot_be_told : ClaimVerdict::impossible};
  claim.why = possible ? fmt::format(
                             "{} It is possible: no route costs less than {:.2f}. Ours: the cheapest route without "
                             "regard to threats, priced on each layout.",
                             kNoFigure3, bound)
                       : fmt::format("No route costs less than {:.2f}, whatever the threats.", bound);
  fill_ours(claim, row, [&](std::size_t l) { return base_cost(study, l, row); });
  return claim;
}

Claim best_cost(const Study& study, std::size_t row) {
  const Published& published = kPublished[row];
  const double distances = least_distance_sum(study);
  const double bound = published.fuel * distances;
  const bool possible = published.best >= bound - kPublishedRounding;
  Claim claim{.id = fmt::format("best-{:.1f}", published.fuel),
              .text = "Best cost at " + weights_of(published),
              .published = published.best,
              .ours = {},
              .unit = "",
              .verdict = possible ? ClaimVerdict::cannot_be_told : ClaimVerdict::impossible};
  claim.why = fmt::format(
      "Whatever the threats, the distances to go sum to {:.2f} or more, so no route costs less than "
      "{:.2f}.",
      distances, bound);
  if (possible)
    claim.why += fmt::format(
        " The printed cost leaves at most {:.1f} for the sum of exposures. {} Ours: mean of {} over "
        "the seeds, on each layout.",
        (published.best - bound) / published.threat, kNoFigure3, kLiteral);
  fill_ours(claim, row, [&](std::size_t l) { return literal_mean(study, l, row); });
  return claim;
}

Claim gain_over_base(const Study& study, std::size_t row) {
  const Published& published = kPublished[row];
  const double most = gain_percent(published.initial, published.fuel * least_distance_sum(study));
  const bool possible = published.gain_percent <= most + kGainRounding;
  Claim claim{.id = fmt::format("gain-{:.1f}", published.fuel),
              .text = "Gain from the initial to the best cost at " + weights_of(published),
              .published = published.gain_percent,
              .ours = {},
              .unit = "%",
              .verdict = possible ? ClaimVerdict::cannot_be_told : ClaimVerdict::impossible};
  claim.why = fmt::format(
      "The bound allows {:.1f} % at most. How much there is to gain depends on how heavily the threats of Figure 3 lie "
      "on "
      "the direct way. Ours: from the base route to the mean of {}.",
      most, kLiteral);
  fill_ours(claim, row, [&](std::size_t l) { return gains_of_literal(study, l)[row]; });
  if (std::ranges::any_of(claim.by_case, [](const auto& each) { return each.second < 0; }))
    claim.why += " Below zero: the ants do worse than the route that knows of no threats.";
  return claim;
}

GainsByRow gains_of_best_routes(const Study& study, std::size_t layout) {
  GainsByRow gains;
  for (std::size_t row = 0; row < gains.size(); ++row) {
    const auto from = base_cost(study, layout, row);
    const Trial* best = study.main.best_trial(Study::case_of(layout, row));
    if (from && best != nullptr) gains[row] = gain_percent(*from, best->best()->metrics.cost);
  }
  return gains;
}

GainsByRow gains_of_literal(const Study& study, std::size_t layout) {
  GainsByRow gains;
  for (std::size_t row = 0; row < gains.size(); ++row) {
    const auto from = base_cost(study, layout, row);
    const auto to = literal_mean(study, layout, row);
    if (from && to) gains[row] = gain_percent(*from, *to);
  }
  return gains;
}

Claim gain_of_ants(const Study& study, std::size_t row) {
  const Published& published = kPublished[row];
  Claim claim{.id = fmt::format("ants-gain-{:.1f}", published.fuel),
              .text = "On our layouts the ants gain as much over their own first routes at " + weights_of(published),
              .published = published.gain_percent,
              .ours = {},
              .unit = "%",
              .why = "Some runs found no route."};
  fill_ours(claim, row, [&](std::size_t l) { return gain_over_first(study.trial(l, row, kLiteral)); });
  if (!claim.ours) return claim;
  const auto [least, most] = std::ranges::minmax(claim.by_case, {}, &std::pair<std::string, double>::second);
  const bool within = published.gain_percent >= least.second && published.gain_percent <= most.second;
  claim.verdict = within ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  claim.why = fmt::format(
      "From its first arrivals to its best, {} gains {:.1f} to {:.1f} % on our layouts, and the stated "
      "gain lies {} that.",
      kLiteral, least.second, most.second, within ? "within" : "outside");
  return claim;
}

}  // namespace alate::konatowski2019
