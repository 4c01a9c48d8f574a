// Labels that carry what may have happened so far, and their dominance.
#pragma once

#include <span>
#include <vector>

#include "search/label_setting/label.hpp"
#include "space/error_cases.hpp"

namespace alate {

/// One way to a node with the cases that are still within all limits.
struct ChanceLabel {
  double length_m = 0;
  double probability = 1;  ///< Of all its cases.
  CorrectionGraph::Node node = 0;
  std::uint32_t parent = kNoLabel;
  int corrections = 0;
  std::uint32_t first_case = 0;
  std::uint32_t case_count = 1;
};

/// Probabilities that differ by less are equal: sums of products round differently.
inline constexpr double kSameProbability = 1e-12;

/// The pool of labels and of their cases, and for each node those that no other dominates.
///
/// X dominates Y if it is no longer, has no more corrections, and for all a, b the probability that X is alive with
/// vertical error <= a and horizontal error <= b is no less than that of Y. This is enough: follow any continuation,
/// and fix which of its corrections fail. The vertical error then develops by itself, never falls when it begins
/// higher, and keeps its limits exactly if it began at or below some a; the horizontal error likewise with some b. So
/// the probability of success is the probability of a quadrant, averaged over what fails, and X has no less of each.
class ChanceLabels {
 public:
  explicit ChanceLabels(std::size_t nodes) : kept_(nodes) {}

  std::span<const ErrorCase> cases_of(const ChanceLabel& label) const {
    return std::span(cases_).subspan(label.first_case, label.case_count);
  }
  /// The error that the last correction did not reset, in the best case; as good as that the other one were 0.
  double least_error(const ChanceLabel& label, PointKind kind) const;

  /// Makes the cases after a leg; `certain`: corrections that may fail do fail. Not kept yet.
  ChanceLabel fly(const Navigation& navigation, std::uint32_t from, const CorrectionLeg& leg, bool certain);
  /// Keeps a label just flown, or forgets its cases if one of its node dominates it. Labels of its own number of
  /// corrections that it dominates are marked.
  bool keep(const ChanceLabel& label);
  /// Forgets the cases of a label just flown.
  void forget(const ChanceLabel& label) { cases_.resize(label.first_case); }

  const ChanceLabel& operator[](std::uint32_t index) const { return pool_[index]; }
  bool is_dominated(std::uint32_t index) const { return dominated_[index]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(pool_.size()); }
  std::vector<CorrectionPoint> points_to(const CorrectionGraph& graph, std::uint32_t last) const;

 private:
  bool dominates(const ChanceLabel& x, const ChanceLabel& y) const;

  std::vector<ChanceLabel> pool_;
  std::vector<bool> dominated_;
  std::vector<ErrorCase> cases_;
  std::vector<ErrorCase> before_;
  std::vector<std::vector<std::uint32_t>> kept_;
};

}  // namespace alate
