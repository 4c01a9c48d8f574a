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

LatticeFlight TerrainLattice::judge(std::span<const std::uint32_t> actions) const {
  LatticeFlight flight;
  flight.is_route = true;
  Node node = frame_.start();
  unsigned came = kFirst;
  double sum = 0;
  const bool counts = !moves_.rules().filters;
  for (const std::uint32_t move : actions) {
    if (!holds(moves_.open(node), move) || !holds(moves_.follows(came), move)) return {};
    if (!holds(moves_.clear(node), move)) {
      flight.is_route = false;
      ++flight.faults.collision;
    }
    if (counts) count_faults(node, came, move, flight.faults);
    sum += score_.of_move(node, move) + (came == kFirst ? 0 : score_.of_turn(came, move));
    flight.length_m += score_.length_m(move);
    node = frame_.after(node, move);
    came = move;
  }
  if (actions.size() != walk_length() || !holds(moves_.joins(node), came)) return {};
  flight.score = sum;
  end_flight(node, came, flight);
  return flight;
}

void TerrainLattice::count_faults(Node node, unsigned came, unsigned move, LatticeFaults& faults) const {
  const Vec3& leg = frame_.shifts()[move].leg;
  faults.leg += moves_.is_short(leg) ? 1U : 0U;
  faults.pitch += moves_.is_steep(leg) ? 1U : 0U;
  faults.turn += came != kFirst && moves_.is_sharp(frame_.shifts()[came].leg, leg) ? 1U : 0U;
  faults.height += moves_.is_high_or_low(frame_.place(frame_.after(node, move))) ? 1U : 0U;
}

void TerrainLattice::end_flight(Node node, unsigned came, LatticeFlight& flight) const {
  flight.score += score_.of_join(node, came);
  flight.length_m += score_.join_length_m(node);
  const LatticeRules& rules = moves_.rules();
  const bool is_long = flight.length_m > rules.limits.length_m;
  flight.faults.length += is_long ? 1U : 0U;
  if (flight.length_m > range_m_ || (rules.filters && is_long)) flight.is_route = false;
  if (rules.filters) return;
  const Vec3 leg = frame_.goal() - frame_.position(node);
  flight.faults.leg += moves_.is_short(leg) ? 1U : 0U;
  flight.faults.pitch += moves_.is_steep(leg) ? 1U : 0U;
  flight.faults.turn += came != kFirst && moves_.is_sharp(frame_.shifts()[came].leg, leg) ? 1U : 0U;
  flight.score += score_.rule().penalty * static_cast<double>(flight.faults.of_constraints());
}

std::optional<Flight> TerrainLattice::fly(std::span<const std::uint32_t> actions) const {
  const LatticeFlight judged = judge(actions);
  if (!judged.is_route) return std::nullopt;
  Flight flight{.cost = judged.score, .moves = actions.size(), .costs = {}};
  Node node = frame_.start();
  for (const std::uint32_t move : actions) {
    flight.costs.push_back(static_cast<float>(score_.of_move(node, move)));
    node = frame_.after(node, move);
  }
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
