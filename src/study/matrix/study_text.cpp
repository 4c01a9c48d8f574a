// A study as a terminal shows it.
#include <fmt/core.h>

#include <algorithm>

#include "study/matrix/analysis.hpp"
#include "study/matrix/by_group.hpp"

namespace alate {

namespace {

std::string gap_text(const MethodFigures& method) {
  if (!method.gap) return "-";
  const std::string margin = method.gap_margin ? fmt::format(" +- {:.3f}", *method.gap_margin) : "";
  return fmt::format("{:.3f} %{}", method.gap->mean, margin);
}

std::string part_text(const Study& study, const StudyRecords& records) {
  const StudyAnalysis analysis = analyse(study, records);
  std::size_t width = 8;
  for (const MethodFigures& method : analysis.methods) width = std::max(width, full_name(study, method).size());
  std::string text =
      fmt::format("{} scenarios, {} runs; means above {} with 95 % confidence\n\n{:<{}}  {:>11}  {:>20}  {:>9}\n",
                  study.scenarios.size(), study.jobs.size(), words_of(analysis.yardstick), "planner", width, "valid",
                  "mean above", "time");
  for (const MethodFigures& method : analysis.methods) {
    const auto valid = std::ranges::count_if(method.records, &StudyRecord::valid);
    text += fmt::format("{:<{}}  {:>11}  {:>20}  {:>6.1f} ms\n", full_name(study, method), width,
                        fmt::format("{} of {}", valid, method.runs), gap_text(method), 1000 * method.mean_s);
  }
  return text;
}

}  // namespace

std::string to_text(const Study& study, const StudyRecords& records) {
  std::string text;
  for (const StudyPart& part : parts_of(study, records)) {
    if (!text.empty()) text += "\n";
    if (!part.name.empty()) text += part.name + ": ";
    text += part_text(part.study, part.records);
  }
  return text;
}

}  // namespace alate
