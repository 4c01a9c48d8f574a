// For each node a falling staircase: what is left to the goal, by the error that one has at the node.
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "space/correction_graph.hpp"

namespace alate {

/// Steps (value, most error) of a node, both rising, one after the other in memory. `at` is the value of the first step
/// that allows the error.
class StepTable {
 public:
  struct Step {
    CorrectionGraph::Node node = 0;
    double value = 0;
    double most_error = 0;
  };

  /// The steps of each node must come in the order of their values.
  StepTable(std::size_t nodes, const std::vector<Step>& steps) : first_(nodes + 1, 0), steps_(steps.size()) {
    for (const Step& step : steps) ++first_[step.node + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    for (const Step& step : steps) steps_[place[step.node]++] = {step.value, step.most_error};
  }

  /// Node i of the new table has the steps of node whole[i].
  StepTable part(std::span<const CorrectionGraph::Node> whole) const {
    StepTable part;
    part.first_.assign(1, 0);
    for (const CorrectionGraph::Node i : whole) {
      part.steps_.insert(part.steps_.end(), steps_.begin() + first_[i], steps_.begin() + first_[i + 1]);
      part.first_.push_back(static_cast<std::uint32_t>(part.steps_.size()));
    }
    return part;
  }

  /// Infinity where no step allows the error.
  double at(CorrectionGraph::Node node, double error) const {
    for (std::uint32_t i = first_[node]; i < first_[node + 1]; ++i)
      if (steps_[i].most_error >= error) return steps_[i].value;
    return std::numeric_limits<double>::infinity();
  }

 private:
  StepTable() = default;

  struct Pair {
    double value = 0;
    double most_error = 0;
  };
  std::vector<std::uint32_t> first_;
  std::vector<Pair> steps_;
};

}  // namespace alate
