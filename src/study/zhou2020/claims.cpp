#include "study/zhou2020/claims.hpp"

#include <fmt/core.h>

#include <cmath>

namespace alate::zhou2020 {

namespace {

/// Chances are printed in whole percent.
constexpr double kChanceRounding = 0.005;

std::vector<int> ids_of(const PublishedRoute& published) {
  std::vector<int> ids = published.points;
  for (int& id : ids) id += published.id_offset;
  return ids;
}

std::string text_of(const PublishedRoute& published) {
  std::string text = fmt::format("{}: {}, {:.6g} km", published.source, case_name(published.set, published.task),
                                 published.length_m / 1000);
  if (published.corrections) text += fmt::format(", {} corrections", *published.corrections);
  if (published.probability) text += fmt::format(", {:.0f} % sure", 100 * *published.probability);
  return text;
}

/// A chance that a printed one may stand for.
std::optional<double> least_chance(const PublishedRoute& published) {
  if (!published.probability) return std::nullopt;
  return *published.probability - kChanceRounding;
}

/// Shorter than any route that is that good can be?
bool too_short(const JudgedRow& row) {
  return row.bound_m && row.published->length_m < *row.bound_m - row.published->rounding_m;
}

std::string bound_words(const JudgedRow& row) {
  const auto& corrections = row.published->corrections;
  const auto& chance = row.published->probability;
  std::string conditions;
  if (corrections) conditions += fmt::format(", has at most {} corrections", *corrections);
  if (chance) conditions += fmt::format(", succeeds with {:.0f} %", 100 * *chance);
  return fmt::format("No route that keeps the limits{} is shorter than {:.2f} m (proven).", conditions, *row.bound_m);
}

/// What differs between a printed route and what is printed about it; empty: nothing.
std::string differences(const PublishedRoute& published, const JudgedRoute& judged) {
  std::string found;
  const double off = judged.metrics.length_m - published.length_m;
  if (std::abs(off) > published.rounding_m + 1e-6)
    found += fmt::format(" Its length is {:.2f} m.", judged.metrics.length_m);
  if (published.corrections && judged.metrics.corrections != static_cast<std::size_t>(*published.corrections))
    found += fmt::format(" It has {} corrections.", judged.metrics.corrections.value_or(0));
  if (published.probability && judged.metrics.probability &&
      std::abs(*judged.metrics.probability - *published.probability) > kChanceRounding)
    found += fmt::format(" It succeeds with {:.2f} %.", 100 * *judged.metrics.probability);
  return found;
}

/// Some who publish routes with turns sum straight legs.
std::string straight_words(const PublishedRoute& published, const Study& study) {
  if (published.task != Task::turning) return "";
  const double straight = judge_route(study.site(published.set, Task::straight), ids_of(published)).metrics.length_m;
  return fmt::format(" Its straight legs alone sum to {:.2f} m.", straight);
}

void judge_printed(JudgedRow& row, const Study& study) {
  const PublishedRoute& published = *row.published;
  const JudgedRoute& judged = *row.judged;
  Claim& claim = row.claim;
  const std::string different = judged.route.empty() ? "" : differences(published, judged);
  const bool holds = judged.feasible() && different.empty();
  claim.verdict = holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  if (!judged.route.empty()) claim.ours = judged.metrics.length_m;
  claim.why =
      judged.feasible() ? "The printed route keeps all limits." : "The printed route breaks: " + judged.broken + ".";
  claim.why += different;
  if (!holds) claim.why += straight_words(published, study);
  if (row.gap) claim.why += fmt::format(" It lies {:.2f} % above the proven optimum.", 100 * *row.gap);
}

void judge_figures(JudgedRow& row) {
  Claim& claim = row.claim;
  claim.ours = row.bound_m;
  claim.verdict = ClaimVerdict::cannot_be_told;
  if (row.bound_m) {
    const double above = row.published->length_m / *row.bound_m - 1;
    claim.why = fmt::format("{} The printed length lies {:.2f} % {} that. ", bound_words(row), 100 * std::abs(above),
                            above < 0 ? "below" : "above");
  }
  claim.why += "The route is not printed.";
}

JudgedRow judge(const Study& study, const PublishedRoute& published) {
  const Plan& proven = study.proven(published.set, published.task);
  JudgedRow row{
      .published = &published,
      .judged = {},
      .bound_m = least_length(proven, published.corrections, least_chance(published)),
      .gap = {},
      .claim = {
          .id = published.id, .text = text_of(published), .published = published.length_m, .ours = {}, .unit = "m"}};
  if (!published.points.empty()) {
    row.judged = judge_route(study.site(published.set, published.task), ids_of(published));
    const auto optimum = least_length(proven, std::nullopt, row.judged->metrics.probability);
    if (row.judged->feasible() && optimum) row.gap = row.judged->metrics.length_m / *optimum - 1;
    judge_printed(row, study);
  } else {
    judge_figures(row);
  }
  if (too_short(row)) {
    row.claim.verdict = ClaimVerdict::impossible;
    if (row.judged) row.claim.why = bound_words(row) + " " + row.claim.why;
  }
  return row;
}

}  // namespace

std::vector<JudgedRow> judge_rows(const Study& study) {
  std::vector<JudgedRow> rows;
  for (const PublishedRoute& published : published_routes()) rows.push_back(judge(study, published));
  return rows;
}

}  // namespace alate::zhou2020
