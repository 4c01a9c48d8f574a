#include "search/lattice_theta.hpp"

#include <algorithm>
#include <bit>
#include <queue>

#include "space/objective.hpp"
#include "space/sure_leg.hpp"

namespace alate {

namespace {

using Node = LatticeFrame::Node;

struct Waiting {
  double bound = 0;
  Node node = 0;

  bool operator<(const Waiting& other) const { return bound != other.bound ? bound > other.bound : node > other.node; }
};

struct Visit {
  double cost = kInfinity;
  Node parent = 0;
  bool is_sure = false;  ///< The leg from the parent is known to be free.
  bool is_expanded = false;
};

class LazyTheta {
 public:
  LazyTheta(const World& world, const TerrainLattice& lattice, RunContext& run)
      : world_(world),
        lattice_(lattice),
        frame_(lattice.frame()),
        objective_(world),
        limits_(world.site()),
        run_(run),
        goal_(frame_.nodes()),
        visits_(std::size_t{frame_.nodes()} + 1) {}

  LatticeWay find() {
    constexpr std::uint64_t kPollEvery = 256;  // each asks for the clearance of many legs
    LatticeWay way;
    visits_[frame_.start()] = {.cost = 0, .parent = frame_.start(), .is_sure = true};
    open_.push({.bound = 0, .node = frame_.start()});
    while (!open_.empty()) {
      const Node node = open_.top().node;
      open_.pop();
      if (visits_[node].is_expanded || !settles(node)) continue;
      visits_[node].is_expanded = true;
      if (node == goal_) {
        way.best = route();
        return way;
      }
      if (++way.expansions % kPollEvery == 0 && !run_.keep_going()) {
        way.finished = false;
        return way;
      }
      expand(node);
    }
    return way;
  }

 private:
  Vec3 position(Node node) const { return node == goal_ ? frame_.goal() : frame_.position(node); }
  bool is_start(Node node) const { return node == frame_.start(); }
  bool is_last(Node node) const { return node >= goal_ - frame_.plane_size(); }

  /// Is the leg short enough a turn after the one that led to `from`, and within all limits of a leg by itself?
  bool allows(Node from, Node to) const {
    const Vec3 leg = position(to) - position(from);
    const LatticeMoves& moves = lattice_.moves();
    if (!limits_.allows(leg) || moves.is_short(leg) || moves.is_steep(leg)) return false;
    if (is_start(from)) return limits_.allows_first(leg);
    const Vec3 before = position(from) - position(visits_[from].parent);
    return limits_.allows_corner(before, leg) && !moves.is_sharp(before, leg);
  }

  double cost_over(Node from, Node to) const {
    return visits_[from].cost + objective_.leg_cost({position(from), position(to)});
  }

  /// Is the node reached? If its straight leg is blocked, then over the cheapest of the moves that lead to it.
  bool settles(Node node) {
    Visit& visit = visits_[node];
    if (visit.is_sure) return true;
    visit.is_sure = is_surely_free(world_, {position(visit.parent), position(node)});
    if (visit.is_sure) return true;
    visit.cost = kInfinity;
    if (node == goal_) {
      for (Node last = goal_ - frame_.plane_size(); last < goal_; ++last)
        if (lattice_.moves().joins(last) != 0) take_move(last, node);
    } else {
      for (unsigned move = 0; move < frame_.moves(); ++move) {
        const Node from = node - frame_.after(0, move);  // wraps round where there is none
        if (from < node && ((lattice_.moves().open(from) >> move) & 1U) != 0) take_move(from, node);
      }
    }
    return visit.is_sure;
  }

  void take_move(Node from, Node to) {
    if (!visits_[from].is_expanded || !allows(from, to)) return;
    const double cost = cost_over(from, to);
    if (cost < visits_[to].cost) visits_[to] = {.cost = cost, .parent = from, .is_sure = true};
  }

  void expand(Node node) {
    if (is_last(node)) {
      if (lattice_.moves().joins(node) != 0) reach(node, goal_);
      return;
    }
    for (unsigned open = lattice_.moves().open(node); open != 0; open &= open - 1)
      reach(node, frame_.after(node, static_cast<unsigned>(std::countr_zero(open))));
  }

  /// A node one move on: straight from the parent, or by the move, whichever is cheaper.
  void reach(Node over, Node to) {
    if (visits_[to].is_expanded) return;
    const Node parent = visits_[over].parent;
    const double straight = !is_start(over) && allows(parent, to) ? cost_over(parent, to) : kInfinity;
    const double moved = allows(over, to) ? cost_over(over, to) : kInfinity;
    const double cost = std::min(straight, moved);
    if (!(cost < visits_[to].cost)) return;
    const bool is_straight = straight <= moved;
    visits_[to] = {.cost = cost, .parent = is_straight ? parent : over, .is_sure = !is_straight};
    open_.push({.bound = cost + lattice_.score().of_straight(position(to)), .node = to});
  }

  std::optional<LatticeOptimum> route() const {
    LatticeOptimum found{.score = visits_[goal_].cost, .places = {frame_.goal()}};
    double length = 0;
    for (Node node = goal_; !is_start(node);) {
      node = visits_[node].parent;
      length += (found.places.back() - position(node)).norm();
      found.places.push_back(position(node));
    }
    if (length > lattice_.longest_m()) return std::nullopt;
    std::ranges::reverse(found.places);
    return found;
  }

  const World& world_;
  const TerrainLattice& lattice_;
  const LatticeFrame& frame_;
  Objective objective_;
  StraightLimits limits_;
  RunContext& run_;
  Node goal_;  ///< No node of the lattice has this number.
  std::vector<Visit> visits_;
  std::priority_queue<Waiting> open_;
};

}  // namespace

LatticeWay lattice_theta(const World& world, const TerrainLattice& lattice, RunContext& run) {
  return LazyTheta(world, lattice, run).find();
}

}  // namespace alate
