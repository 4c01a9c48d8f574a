#include "search/lattice_astar.hpp"

#include <algorithm>
#include <bit>
#include <queue>

namespace alate {

namespace {

using Node = LatticeFrame::Node;
constexpr unsigned kFirst = LatticeFrame::kFirst;
constexpr std::uint32_t kNoLabel = ~std::uint32_t{0};
constexpr std::size_t kMostLabels = 16'000'000;  // 768 MB with their places in the queue

/// A string of moves from the start.
struct Label {
  double score = 0;
  double length_m = 0;
  Node node = 0;  ///< nodes(): the goal.
  std::uint32_t before = kNoLabel;
  std::uint8_t came = kFirst;
};

/// Labels wait by what they cost at least, the newest first among equals.
struct Waiting {
  double bound = 0;
  std::uint32_t label = 0;

  bool operator<(const Waiting& other) const {
    return bound != other.bound ? bound > other.bound : label < other.label;
  }
};

class AStar {
 public:
  /// `longest_m`: no string may be longer.
  AStar(const TerrainLattice& lattice, double longest_m, RunContext& run)
      : lattice_(lattice),
        frame_(lattice.frame()),
        longest_m_(longest_m),
        run_(run),
        minds_turns_(lattice.moves().minds_turns() || lattice.score().minds_turns()),
        least_((minds_turns_ ? kFirst + 1 : 1) * std::size_t{frame_.nodes()}, kInfinity) {}

  bool is_full() const { return labels_.size() >= kMostLabels; }

  LatticeWay find() {
    constexpr std::uint64_t kPollEvery = 1024;
    LatticeWay way{.finished = false};
    add({.node = frame_.start()});
    while (!open_.empty()) {
      const std::uint32_t at = open_.top().label;
      open_.pop();
      if (labels_[at].node == frame_.nodes()) {
        way.best = LatticeOptimum{.score = labels_[at].score, .places = places(at)};
        break;
      }
      if (!keeps(labels_[at])) continue;
      if (++way.expansions % kPollEvery == 0 && (is_full() || !run_.keep_going())) return way;
      expand(at);
    }
    way.finished = true;
    return way;
  }

 private:
  std::size_t state(const Label& label) const {
    return minds_turns_ ? (kFirst + 1) * std::size_t{label.node} + label.came : label.node;
  }

  bool is_limited() const { return longest_m_ < kInfinity; }

  /// Of the labels of a state, which come by rising score, those that are shorter than all before them; without a limit
  /// the first.
  bool keeps(const Label& label) {
    double& least = least_[state(label)];
    if (!is_limited()) return label.score <= least;
    if (!(label.length_m < least)) return false;
    least = label.length_m;
    return true;
  }

  void expand(std::uint32_t at) {
    const Label from = labels_[at];
    const LatticeMoves& moves = lattice_.moves();
    if (frame_.place(from.node).plane + 1 == frame_.planes()) {
      if (((moves.joins(from.node) >> from.came) & 1U) != 0) join(from, at);
      return;
    }
    const unsigned may = moves.open(from.node) & moves.clear(from.node) & moves.follows(from.came);
    for (unsigned rest = may; rest != 0; rest &= rest - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(rest));
      add({.score = from.score + lattice_.score().of_step(from.node, from.came, move),
           .length_m = from.length_m + lattice_.score().length_m(move),
           .node = frame_.after(from.node, move),
           .before = at,
           .came = static_cast<std::uint8_t>(move)});
    }
  }

  void join(const Label& from, std::uint32_t at) {
    const Label arrived{.score = from.score + lattice_.score().of_join(from.node, from.came),
                        .length_m = from.length_m + lattice_.score().join_length_m(from.node),
                        .node = frame_.nodes(),
                        .before = at};
    if (arrived.length_m <= longest_m_) enter(arrived, arrived.score);
  }

  void add(const Label& label) {
    constexpr double kHair = 1e-12;  // a sum of legs in another order
    double& least = least_[state(label)];
    if (!((is_limited() ? label.length_m : label.score) < least)) return;
    if (!is_limited()) least = label.score;
    const auto place = frame_.place(label.node);
    const Vec3 at = frame_.position(place);
    if ((label.length_m + (frame_.goal() - at).norm()) * (1 - kHair) > longest_m_) return;
    const double legs = frame_.planes() - place.plane;
    enter(label, label.score + lattice_.score().of_straight(at) + legs * lattice_.score().least_of_end());
  }

  void enter(const Label& label, double bound) {
    open_.push({.bound = bound, .label = static_cast<std::uint32_t>(labels_.size())});
    labels_.push_back(label);
  }

  std::vector<Vec3> places(std::uint32_t at) const {
    std::vector<Vec3> places{frame_.goal()};
    while ((at = labels_[at].before) != kNoLabel) places.push_back(frame_.position(labels_[at].node));
    std::ranges::reverse(places);
    return places;
  }

  const TerrainLattice& lattice_;
  const LatticeFrame& frame_;
  double longest_m_;
  RunContext& run_;
  bool minds_turns_;
  std::vector<double> least_;  ///< By state: score of its labels; with a limit, length of those that were expanded.
  std::vector<Label> labels_;
  std::priority_queue<Waiting> open_;
};

double length(const std::vector<Vec3>& places) {
  double sum = 0;
  for (std::size_t i = 1; i < places.size(); ++i) sum += (places[i] - places[i - 1]).norm();
  return sum;
}

/// Whatever the limit of the route's length.
LatticeWay cheapest(const TerrainLattice& lattice, RunContext& run) {
  AStar astar(lattice, kInfinity, run);
  LatticeWay way = astar.find();
  if (!way.finished && astar.is_full()) way = {.best = lattice_optimum(lattice), .expansions = way.expansions};
  return way;
}

}  // namespace

LatticeWay lattice_astar(const TerrainLattice& lattice, RunContext& run) {
  constexpr double kHair = 1e-12;  // a sum of legs in another order
  LatticeWay way = cheapest(lattice, run);
  if (!way.best || length(way.best->places) * (1 + kHair) <= lattice.longest_m()) return way;
  LatticeWay within = AStar(lattice, lattice.longest_m(), run).find();
  within.expansions += way.expansions;
  return within;
}

}  // namespace alate
