#include "space/terrain_lattice.hpp"

namespace alate {

namespace {

constexpr bool holds(unsigned set, unsigned move) { return ((set >> move) & 1U) != 0; }

}  // namespace

TerrainLattice::TerrainLattice(const World& world, LatticeFrame frame, const LatticeOptions& options, RunContext& run)
    : frame_(std::move(frame)),
      moves_(world, frame_, options.rules, run),
      score_(world, frame_, moves_, options.score),
      range_m_(world.site().vehicle.range_m.value_or(kInfinity)) {}

std::optional<std::vector<TerrainLattice::Edge>> TerrainLattice::edges(std::span<const std::uint32_t> actions) const {
  std::vector<Edge> edges;
  Node node = frame_.start();
  unsigned came = kFirst;
  for (const std::uint32_t move : actions) {
    if (!holds(moves_.open(node), move) || !holds(moves_.follows(came), move)) return std::nullopt;
    edges.push_back(kRow * node + move);
    node = frame_.after(node, move);
    came = move;
  }
  return edges;
}

LatticeFlight TerrainLattice::judge(std::span<const Edge> edges) const {
  LatticeFlight flight;
  if (edges.size() != walk_length()) return flight;
  unsigned came = kFirst;
  double sum = 0;
  for (const Edge edge : edges) {
    const unsigned move = edge % kRow;
    sum += score_.of_step(edge / kRow, came, move);
    flight.length_m += score_.length_m(move);
    came = move;
  }
  const Node last = edges.empty() ? frame_.start() : frame_.after(edges.back() / kRow, came);
  if (!holds(moves_.joins(last), came)) return flight;
  flight.score = sum;
  flight.is_route = true;
  join(last, came, flight);
  if (!moves_.rules().filters || !moves_.rules().whole_legs) count_faults(edges, flight);
  return flight;
}

void TerrainLattice::join(Node node, unsigned came, LatticeFlight& flight) const {
  flight.score += score_.of_join(node, came);
  flight.length_m += score_.join_length_m(node);
  const LatticeRules& rules = moves_.rules();
  const bool is_long = flight.length_m > rules.limits.length_m;
  flight.faults.length += is_long ? 1U : 0U;
  if (flight.length_m > range_m_ || (rules.filters && is_long)) flight.is_route = false;
}

void TerrainLattice::count_leg(const Vec3* before, const Vec3& leg, LatticeFaults& faults) const {
  faults.leg += moves_.is_short(leg) ? 1U : 0U;
  faults.pitch += moves_.is_steep(leg) ? 1U : 0U;
  faults.turn += before != nullptr && moves_.is_sharp(*before, leg) ? 1U : 0U;
}

/// What a walk by the rules need not ask.
void TerrainLattice::count_faults(std::span<const Edge> edges, LatticeFlight& flight) const {
  LatticeFaults& faults = flight.faults;
  const Vec3* before = nullptr;
  Vec3 at = frame_.position(frame_.start());
  for (const Edge edge : edges) {
    const Node to = frame_.after(edge / kRow, edge % kRow);
    const Vec3& leg = frame_.shifts()[edge % kRow].leg;
    faults.collision += holds(moves_.clear(edge / kRow), edge % kRow) ? 0U : 1U;
    faults.height += moves_.is_high_or_low(frame_.place(to)) ? 1U : 0U;
    count_leg(before, leg, faults);
    before = &leg;
    at = frame_.position(to);
  }
  count_leg(before, frame_.goal() - at, faults);
  if (faults.collision > 0) flight.is_route = false;
  if (!moves_.rules().filters) flight.score += score_.rule().penalty * static_cast<double>(faults.of_constraints());
}

std::optional<FlownActions> TerrainLattice::fly(std::span<const std::uint32_t> actions) const {
  const auto string = edges(actions);
  if (!string) return std::nullopt;
  const LatticeFlight judged = judge(*string);
  if (!judged.is_route) return std::nullopt;
  FlownActions flight{.cost = judged.score, .moves = actions.size(), .costs = {}};
  for (const Edge edge : *string) flight.costs.push_back(static_cast<float>(score_.of_move(edge / kRow, edge % kRow)));
  return flight;
}

std::vector<Vec3> TerrainLattice::places(std::span<const std::uint32_t> actions) const {
  Node node = frame_.start();
  std::vector<Vec3> places{frame_.position(node)};
  for (const std::uint32_t move : actions) places.push_back(frame_.position(node = frame_.after(node, move)));
  places.push_back(frame_.goal());
  return places;
}

}  // namespace alate
