// Correction points as ants see them: choices are the points worth flying to next, as far as the errors allow.
#pragma once

#include <optional>
#include <span>

#include "space/choices.hpp"
#include "space/point_string.hpp"
#include "space/successors.hpp"

namespace alate {

/// Where an ant is: all there is to know after a correction.
struct CorrectionState {
  CorrectionGraph::Node node = 0;
  double error = 0;
};

/// Action k of a node is the k-th of its successors. Places are relative to the start in single precision, to a
/// centimetre at 100 km, and serve as names of points: trails lie on points. The cost of a move is its share of F, the
/// guide the relaxed rest of the way, corrections not counted.
class CorrectionAnts {
 public:
  using State = CorrectionState;

  /// All must outlive this.
  CorrectionAnts(const CorrectionGraph& graph, const RelaxedToGo& to_go, const Successors& successors,
                 const RoutePrice& price, std::size_t step_limit)
      : graph_(graph), to_go_(to_go), successors_(successors), price_(price), step_limit_(step_limit) {}

  State start() const { return {.node = graph_.start()}; }
  std::size_t actions() const { return successors_.longest(); }
  std::size_t step_limit() const { return step_limit_; }

  void look(const State& state, Choices& out) const;
  State next(const State& state, std::size_t k) const {
    const Successors::Arc& arc = successors_.of(state.node)[k];
    return {.node = arc.to, .error = graph_.leg(state.node, arc.to).after(state.error, arc.length_m)};
  }
  bool is_free(const State& from, const State& to) const { return graph_.is_free(from.node, to.node); }
  bool is_goal(const State& state) const { return state.node == graph_.goal(); }
  Eigen::Vector3f place(const State& state) const { return place(state.node); }

  /// F of a string of actions; nothing if it breaks a limit, meets an obstacle, or does not arrive.
  std::optional<FlownActions> fly(std::span<const std::uint32_t> actions) const;

  /// Points on the way, without start and goal.
  PointString points(std::span<const std::uint32_t> actions) const;
  /// The actions that lead over `points` to the goal; nothing where one is not among the successors.
  std::optional<std::vector<std::uint32_t>> actions(const PointString& points) const;

 private:
  Eigen::Vector3f place(CorrectionGraph::Node node) const {
    return (graph_.position(node) - graph_.position(graph_.start())).cast<float>();
  }
  double cost(const Successors::Arc& arc) const { return price_.of(arc.length_m, arc.to == graph_.goal() ? 0 : 1); }

  const CorrectionGraph& graph_;
  const RelaxedToGo& to_go_;
  const Successors& successors_;
  RoutePrice price_;
  std::size_t step_limit_;
};

}  // namespace alate
