#include "search/lattice_optimum.hpp"

#include <algorithm>
#include <bit>

namespace alate {

namespace {

using Node = LatticeFrame::Node;
constexpr unsigned kFirst = LatticeFrame::kFirst;
constexpr std::size_t kLabels = kFirst + 1;  ///< Of a node: by the move that led to it.

template <class Use>
void for_each_move(unsigned moves, const Use& use) {
  for (; moves != 0; moves &= moves - 1) use(static_cast<unsigned>(std::countr_zero(moves)));
}

class Planes {
 public:
  explicit Planes(const TerrainLattice& lattice)
      : lattice_(lattice),
        frame_(lattice.frame()),
        least_(kLabels * frame_.nodes(), kInfinity),
        before_(kLabels * frame_.nodes(), kFirst) {
    least_[label(frame_.start(), kFirst)] = 0;
    const Node last = frame_.nodes() - frame_.plane_size();
    for (Node node = 0; node < last; ++node) leave(node);  // nodes are numbered plane by plane
    for (Node node = last; node < frame_.nodes(); ++node) arrive(node);
  }

  std::optional<LatticeOptimum> optimum() const {
    if (!(score_ < kInfinity)) return std::nullopt;
    return LatticeOptimum{.score = score_, .places = places()};
  }

 private:
  static std::size_t label(Node node, unsigned came) { return kLabels * node + came; }

  void leave(Node node) {
    const LatticeMoves& moves = lattice_.moves();
    for (unsigned came = 0; came < kLabels; ++came) {
      const double so_far = least_[label(node, came)];
      if (!(so_far < kInfinity)) continue;
      for_each_move(moves.clear(node) & moves.follows(came), [&](unsigned move) {
        const std::size_t next = label(frame_.after(node, move), move);
        const double sum = so_far + lattice_.score().of_step(node, came, move);
        if (!(sum < least_[next])) return;
        least_[next] = sum;
        before_[next] = static_cast<std::uint8_t>(came);
      });
    }
  }

  void arrive(Node node) {
    for (unsigned came = 0; came < kLabels; ++came) {
      const double so_far = least_[label(node, came)];
      if (!(so_far < kInfinity) || ((lattice_.moves().joins(node) >> came) & 1U) == 0) continue;
      const double sum = so_far + lattice_.score().of_join(node, came);
      if (!(sum < score_)) continue;
      score_ = sum;
      last_ = node;
      last_came_ = came;
    }
  }

  std::vector<Vec3> places() const {
    std::vector<Vec3> places{frame_.goal()};
    Node node = last_;
    unsigned came = last_came_;
    while (came != kFirst) {
      places.push_back(frame_.position(node));
      const unsigned earlier = before_[label(node, came)];
      node -= frame_.after(0, came);  // what the move adds to the number of any node
      came = earlier;
    }
    places.push_back(frame_.position(node));
    std::ranges::reverse(places);
    return places;
  }

  const TerrainLattice& lattice_;
  const LatticeFrame& frame_;
  std::vector<double> least_;
  std::vector<std::uint8_t> before_;  ///< The move before the last one.
  double score_ = kInfinity;
  Node last_ = 0;
  unsigned last_came_ = kFirst;
};

}  // namespace

std::optional<LatticeOptimum> lattice_optimum(const TerrainLattice& lattice) { return Planes(lattice).optimum(); }

}  // namespace alate
