#include "space/correction_ants.hpp"

namespace alate {

void CorrectionAnts::look(const State& state, Choices& out) const {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  out.resize(actions());
  const auto arcs = successors_.of(state.node);
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const Successors::Arc& arc = arcs[k];
    const Eigen::Vector3f at = place(arc.to);
    out.x[k] = at.x();
    out.y[k] = at.y();
    out.z[k] = at.z();
    out.to_goal[k] = static_cast<float>(graph_.to_goal(arc.to));
    out.guide[k] = static_cast<float>(price_.of(to_go_(arc.to), 0));
    const bool may_fly = graph_.leg(state.node, arc.to).keeps_limits(state.error, arc.length_m);
    out.cost[k] = may_fly ? static_cast<float>(cost(arc)) : kNever;
  }
  for (std::size_t k = arcs.size(); k < out.cost.size(); ++k) {
    out.x[k] = out.y[k] = out.z[k] = out.to_goal[k] = out.guide[k] = 0;
    out.cost[k] = kNever;
  }
}

std::optional<FlownActions> CorrectionAnts::fly(std::span<const std::uint32_t> actions) const {
  FlownActions flight;
  State state = start();
  for (const std::uint32_t k : actions) {
    const Successors::Arc& arc = successors_.of(state.node)[k];
    const State ahead = next(state, k);
    const bool may_fly = graph_.leg(state.node, arc.to).keeps_limits(state.error, arc.length_m);
    if (!may_fly || !is_free(state, ahead)) return std::nullopt;
    flight.cost += cost(arc);
    flight.costs.push_back(static_cast<float>(cost(arc)));
    ++flight.moves;
    state = ahead;
    if (is_goal(state)) return flight;
  }
  return std::nullopt;
}

PointString CorrectionAnts::points(std::span<const std::uint32_t> actions) const {
  PointString points;
  CorrectionGraph::Node node = graph_.start();
  for (const std::uint32_t k : actions) {
    node = successors_.of(node)[k].to;
    if (node == graph_.goal()) break;
    points.push_back(node);
  }
  return points;
}

std::optional<std::vector<std::uint32_t>> CorrectionAnts::actions(const PointString& points) const {
  std::vector<std::uint32_t> actions;
  CorrectionGraph::Node node = graph_.start();
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const CorrectionGraph::Node to = i < points.size() ? points[i] : graph_.goal();
    const auto arcs = successors_.of(node);
    const auto found = std::ranges::find(arcs, to, &Successors::Arc::to);
    if (found == arcs.end()) return std::nullopt;
    actions.push_back(static_cast<std::uint32_t>(found - arcs.begin()));
    node = to;
  }
  return actions;
}

}  // namespace alate
