// Seeds and budgets of a study.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/number_text.hpp"
#include "data/limits.hpp"
#include "study/matrix/ranges.hpp"
#include "study/matrix/study_parts.hpp"

namespace alate {

namespace {

/// Limits of a number in a study.
struct Bounds {
  double min = 0;
  double max = 0;
  bool whole = true;
};

std::optional<double> read_number(const Node& node, const std::string& field, const Bounds& bounds,
                                  StudyFaults& faults) {
  if (!faults.is_word(node, field)) return std::nullopt;
  const NumberText number = parse_number(node.text);
  std::string problem = node.quoted ? "must be a number, without quotes" : number.problem;
  if (problem.empty() && bounds.whole && number.value != std::floor(number.value)) problem = "must be a whole number";
  if (problem.empty() && (number.value < bounds.min || number.value > bounds.max)) problem = "out of range";
  if (problem.empty()) return number.value;
  faults.report(node.place, {.field = field,
                             .value = node.text,
                             .limit = fmt::format("{:.10g} to {:.10g}", bounds.min, bounds.max),
                             .message = std::move(problem)});
  return std::nullopt;
}

constexpr Bounds kSeedBounds{.min = 0, .max = kMaxMagnitude};

void read_seed(const Node& node, const std::string& field, std::vector<std::uint64_t>& seeds, StudyFaults& faults) {
  const auto range = range_of(node);
  if (!range) {
    if (const auto seed = read_number(node, field, kSeedBounds, faults))
      seeds.push_back(static_cast<std::uint64_t>(*seed));
    return;
  }
  const auto [from, to] = *range;
  if (from < 0 || to < from || static_cast<std::size_t>(to - from) >= kMaxStudySeeds)
    return faults.report(node.place, {.field = field,
                                      .value = node.text,
                                      .limit = fmt::format("a..b, 0 <= a <= b, {} seeds", kMaxStudySeeds),
                                      .message = "is no range of seeds"});
  for (std::int64_t seed = from; seed <= to; ++seed) seeds.push_back(static_cast<std::uint64_t>(seed));
}

std::optional<StudyBudget> read_budget(const Node& item, const std::string& field, StudyFaults& faults) {
  if (item.kind == Node::Kind::broken) return std::nullopt;
  if (item.kind == Node::Kind::map) faults.check_keys(item, field, {"iterations", "time_s"});
  const Node* iterations = item.find("iterations");
  const Node* time = item.find("time_s");
  if ((iterations == nullptr) == (time == nullptr)) {
    faults.report(item.place,
                  {.field = field, .limit = "iterations | time_s", .message = "needs exactly one of these keys"});
    return std::nullopt;
  }
  StudyBudget budget;
  if (iterations != nullptr) {
    const auto number = read_number(*iterations, field + ".iterations", {.min = 1, .max = 1e6}, faults);
    if (!number) return std::nullopt;
    budget.iterations = static_cast<std::uint64_t>(*number);
  } else {
    budget.time_s = read_number(*time, field + ".time_s", {.min = 0.001, .max = 86400, .whole = false}, faults);
    if (!budget.time_s) return std::nullopt;
  }
  return budget;
}

}  // namespace

std::string StudyBudget::text() const {
  if (iterations) return fmt::format("iterations={}", *iterations);
  return time_s ? fmt::format("time_s={}", *time_s) : "default";
}

std::vector<std::uint64_t> read_study_seeds(const Node& node, StudyFaults& faults) {
  std::vector<std::uint64_t> seeds;
  if (node.kind == Node::Kind::scalar) {
    read_seed(node, "seeds", seeds, faults);
  } else if (faults.is_list(&node, node, "seeds", kMaxStudySeeds)) {
    for (std::size_t i = 0; i < node.children.size() && seeds.size() <= kMaxStudySeeds; ++i)
      read_seed(node.children[i], fmt::format("seeds.{}", i), seeds, faults);
  }
  if (std::set(seeds.begin(), seeds.end()).size() != seeds.size())
    faults.report(node.place, {.field = "seeds", .message = "a seed is given twice"});
  return seeds;
}

std::vector<StudyBudget> read_study_budgets(const Node& list, StudyFaults& faults) {
  std::vector<StudyBudget> budgets;
  for (std::size_t i = 0; i < list.children.size(); ++i) {
    const std::string field = fmt::format("budgets.{}", i);
    const auto budget = read_budget(list.children[i], field, faults);
    if (!budget) continue;
    if (std::ranges::find(budgets, budget->text(), &StudyBudget::text) != budgets.end())
      faults.report(list.children[i].place, {.field = field, .value = budget->text(), .message = "given twice"});
    budgets.push_back(*budget);
  }
  return budgets;
}

}  // namespace alate
