#include "study/mai2023/optimum.hpp"

#include <algorithm>
#include <bit>

#include "alate/core/executor.hpp"

namespace alate::mai2023 {

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

  std::optional<Optimum> optimum() const {
    if (!(fitness_ < kInfinity)) return std::nullopt;
    return Optimum{.fitness = fitness_, .places = places()};
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
      if (!(sum < fitness_)) continue;
      fitness_ = sum;
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
  double fitness_ = kInfinity;
  Node last_ = 0;
  unsigned last_came_ = kFirst;
};

}  // namespace

LatticeOptions lattice_options(const ParamValues& values) {
  return {.steps = {.window_side = static_cast<int>(values.integer("window_side")),
                    .window_height = static_cast<int>(values.integer("window_height"))},
          .rules = {.limits = {.pitch_rad = radians(values.number("pitch_max_deg")),
                               .turn_rad = radians(values.number("turn_max_deg"))},
                    .safe_agl_m = values.number("safe_height_m"),
                    .any_join = values.text("join") == "any",
                    .prunes = false},
          .score = {.rule = TerrainScore::Rule::paper,
                    .length = values.number("weight_length"),
                    .height = values.number("weight_height"),
                    .turn = values.number("weight_turn")}};
}

std::optional<Optimum> least_fitness(const TerrainLattice& lattice) { return Planes(lattice).optimum(); }

std::optional<Optimum> least_fitness(const World& world, const ParamValues& values) {
  const LatticeOptions options = lattice_options(values);
  Executor alone(1);
  RunContext run(alone, {});
  const TerrainLattice lattice(world, LatticeFrame(world, options.steps), options, run);
  return least_fitness(lattice);
}

}  // namespace alate::mai2023
