// What is left to fly and to correct from a point with an error: backward searches, tables and bounds.
#pragma once

#include <algorithm>
#include <limits>

#include "alate/core/run_context.hpp"
#include "search/label_setting/step_table.hpp"

namespace alate {

/// How far one leg, and two legs with one correction between them, can lead at most; from this the least number of
/// corrections on a way of a given length.
class LegReach {
 public:
  explicit LegReach(const CorrectionGraph& graph);

  /// Of points after the start (themselves counted) on any way of this length, at least.
  int least_corrections(double distance_m) const;
  /// No way with `corrections` leads farther.
  double farthest_m(int corrections) const;
  /// Longest leg to a point.
  double one_m() const { return one_m_; }

 private:
  double one_m_ = 0;
  double two_m_ = 0;
};

/// Lower bounds on the length left from a point with an error. Bounds hold for straight legs, and so for legs with
/// turns. They are never above the truth, rounding included.
class RemainingLength {
 public:
  /// Exact, to rounding, for routes up to `upper_m`; for longer ones the bound says no more than that they are.
  RemainingLength(const CorrectionGraph& graph, double upper_m, RunContext& run);

  /// With `upper_m` infinite: infinity where the goal cannot be reached.
  double at(CorrectionGraph::Node node, double error) const;
  /// The shortest route, and its corrections; infinity where none is within `upper_m`.
  double shortest_m() const { return shortest_m_; }
  int shortest_corrections() const { return shortest_corrections_; }
  /// `run` ended the search: the table is not to be used.
  bool stopped() const { return stopped_; }
  std::uint64_t labels() const { return labels_; }

 private:
  std::vector<StepTable::Step> search(RunContext& run);
  void note_arrival(double length_m, int corrections);

  const CorrectionGraph* graph_;
  double upper_m_;
  double shortest_m_ = std::numeric_limits<double>::infinity();
  int shortest_corrections_ = 0;
  bool stopped_ = false;
  std::uint64_t labels_ = 0;
  StepTable table_;
};

/// Lower bounds on the corrections left after a point, by an exact backward sweep, layer by layer.
class RemainingCorrections {
 public:
  /// Exact, to rounding, for routes with up to `most` corrections; others are only known to have more.
  RemainingCorrections(const CorrectionGraph& graph, int most, RunContext& run);
  /// The same bounds for a part of the graph.
  RemainingCorrections(const RemainingCorrections& whole, const CorrectionGraph& part);

  int at(CorrectionGraph::Node node, double error) const;
  /// Corrections of a whole route that comes to the node with `before` of them, its own included. Holds for routes of
  /// any number: where more than `most` are needed, it says no more than that.
  int in_all(CorrectionGraph::Node node, double error, int before) const {
    return std::min(before + at(node, error), std::max(before, most_ + 1));
  }
  /// On any route; more than `most` where none has as few.
  int fewest() const { return at(graph_->start(), 0); }
  int most() const { return most_; }
  bool stopped() const { return stopped_; }
  std::uint64_t labels() const { return labels_; }

 private:
  std::vector<StepTable::Step> sweep(RunContext& run);

  const CorrectionGraph* graph_;
  LegReach reach_;
  int most_;
  bool stopped_ = false;
  std::uint64_t labels_ = 0;
  StepTable table_;
};

}  // namespace alate
