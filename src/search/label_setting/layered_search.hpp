// The shortest routes with up to so many corrections, layer by layer.
#pragma once

#include "search/label_setting/label.hpp"
#include "search/label_setting/label_stairs.hpp"
#include "search/label_setting/remaining.hpp"

namespace alate {

/// For routes with up to fewest + i corrections only lengths up to most_m[i] are looked for; most_m never rises.
struct LengthCaps {
  int fewest = 0;
  std::vector<double> most_m;

  int most() const { return fewest + static_cast<int>(most_m.size()) - 1; }
};

/// Labels (length, error) of each node, all those with k corrections before those with k + 1. A label is passed over if
/// one of its node with no more corrections is as good in both, or if what is left to fly and to correct would take it
/// over every cap. Every transition is monotone in the error, so nothing is lost (Zhou et al. 2020 have no exact
/// method). Labels of layer k + 1 never dominate those of layer k: they have more corrections.
class LayeredSearch {
 public:
  /// `length` may be null: then the straight line bounds what is left.
  struct Bounds {
    const RemainingCorrections& corrections;
    const RemainingLength* length = nullptr;
  };

  LayeredSearch(const CorrectionGraph& graph, const Bounds& bounds, const LengthCaps& caps);
  void run(RunContext& run);

  /// The shortest route found with up to fewest + i corrections; its length is infinite where there is none. Proven if
  /// its length is within the cap.
  double length_m(std::size_t i) const { return best_[i].length_m; }
  CorrectionRoute route(std::size_t i) const;
  bool stopped() const { return stopped_; }
  std::uint64_t labels() const { return expanded_; }

 private:
  void expand(std::uint32_t index, int corrections);
  void fly_home(std::uint32_t index, const Label& from);
  bool can_lead_home(CorrectionGraph::Node j, const Label& label) const;

  const CorrectionGraph& graph_;
  Bounds bounds_;
  LengthCaps caps_;
  LabelStairs stairs_;
  std::vector<Label> pool_;
  std::vector<bool> dominated_;  ///< By a label of its own layer.
  std::vector<std::uint32_t> next_;
  std::vector<Label> best_;  ///< At the goal, for each cap.
  std::uint64_t expanded_ = 0;
  bool stopped_ = false;
};

}  // namespace alate
