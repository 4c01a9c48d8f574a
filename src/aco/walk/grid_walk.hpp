// Ants on a grid, several at once: while one waits for a cell to come from memory, the others step.
//
// Source: alate. Every ant draws from its own Stream and reads tables that nobody changes, so how ants are interleaved
// does not show. Cost: 5 to 10 ns a step where a table holds the choices.
//
// As in the papers a visited cell is tabu, and an ant without a free neighbour is dead: no score, no deposit. Optional:
// - it steps back instead; with no limit on that it always arrives where there is a way (cells stay tabu);
// - ants begin with a random part of the best route so far (iterated ants: Wiesemann, Stuetzle 2006);
// - ant 0 repeats the best route so far and deposits like any other: the public program for Li et al. 2019 [C].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "aco/ant.hpp"
#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "alate/core/run_context.hpp"
#include "alate/core/stream.hpp"
#include "space/height_grid.hpp"

namespace alate {

struct GridWalkOptions {
  std::size_t ants = 50;
  std::uint64_t iterations = 30;  ///< Where neither a budget nor a time limit is given.
  double follow = 0;              ///< Share of ants that begin with a part of the best route.
  double give_up = 0;             ///< An ant that will be longer than the best by this share ends; 0: never.
  std::size_t step_backs = 0;     ///< Of one ant, at most.
  bool repeat_best = false;
};

/// Where an ant is, as a choice of moves sees it.
struct GridStand {
  GridSpace::Cell cell = 0;
  unsigned came = GridSpace::kNoDirection;  ///< Direction of the last move.
  unsigned tabu = 0;                        ///< Bit d: the neighbour in direction d has been visited.
};

template <class Policies>
class GridWalk {
 public:
  using Options = GridWalkOptions;

  GridWalk(const GridSpace& space, const Options& options)
      : space_(space),
        options_(options),
        groups_(std::clamp<std::size_t>(options.ants / (4 * kSlots), 1, kMostGroups)),
        offsets_(space.offsets()),
        stride_(offsets_[6]) {
    for (Group& group : groups_)
      for (Slot& slot : group) slot.resize(space.cells());
    for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
      ahead_.push_back(static_cast<float>(space.octile(cell, space.goal())));
  }

  void operator()(Policies& policies, std::vector<Ant>& ants, const Ant& best, RunContext& run) {
    policies.choice.prepare(policies.trail);
    const Shift shift{policies, ants, best, run};
    run.executor().for_ranges(groups_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t group = begin; group < end; ++group) walk(shift, group);
    });
  }

  /// Moves of a route that was changed after the walk, and its length.
  void name_route(const Policies& policies, Ant& ant) const {
    ant.keys.clear();
    ant.sum = space_.measure(ant.actions).length_cells;
    GridSpace::Cell cell = space_.start();
    for (const std::uint32_t direction : ant.actions) {
      ant.keys.push_back(MoveCells::key(cell, direction));
      cell = space_.neighbour(cell, direction);
    }
    count_known(policies, ant);
  }

  /// The history tells lengths, whatever the score.
  static double told(const Ant& ant) { return ant.sum; }

 private:
  static constexpr std::size_t kSlots = 4;  ///< Ants at once; 8 and 12 are no faster.
  static constexpr std::size_t kMostGroups = 16;
  static constexpr std::size_t kPollEvery = 256;

  /// One iteration.
  struct Shift {
    const Policies& policies;
    std::vector<Ant>& ants;
    const Ant& best;
    RunContext& run;
  };

  /// An ant on its way. Nothing is allocated: a tabu walk is no longer than there are cells.
  struct Slot {
    GridStand at;
    float left = 0;  ///< Length until it gives up.
    std::size_t moves = 0;
    Stream stream{0, 0, 0};
    Ant* ant = nullptr;
    std::vector<std::uint32_t> path;    ///< Moves: 8 cell + direction.
    std::vector<std::uint8_t> tabu;     ///< GridStand::tabu of every cell: one look a step instead of eight.
    std::vector<GridSpace::Cell> dead;  ///< Stepped back from.

    void resize(std::size_t cells) {
      path.resize(cells);
      tabu.resize(cells + sizeof(std::uint32_t));
    }
  };
  using Group = std::array<Slot, kSlots>;

  std::size_t first_of(const Shift& shift, std::size_t group) const {
    return group * shift.ants.size() / groups_.size();
  }

  void walk(const Shift& shift, std::size_t group) {
    std::size_t next = first_of(shift, group);
    const std::size_t last = first_of(shift, group + 1);
    std::array<Slot*, kSlots> active{};
    std::size_t count = 0;
    const auto seat = [&](Slot& slot) {
      while (next < last)
        if (set_out(shift, shift.ants[next++], slot)) return true;
      return false;
    };
    for (Slot& slot : groups_[group])
      if (seat(slot)) active[count++] = &slot;
    for (std::size_t round = 0; count > 0; ++round) {
      if (round % kPollEvery == 0 && !shift.run.keep_going()) break;
      for (std::size_t i = 0; i < count;) {
        Slot& slot = *active[i];
        if (step(shift, slot)) {
          ++i;
          continue;
        }
        finish(shift, slot);
        if (!seat(slot)) active[i] = active[--count];
      }
    }
    for (std::size_t i = 0; i < count; ++i) finish(shift, *active[i]);
    for (; next < last; ++next) shift.ants[next].restart();
  }

  /// Puts an ant at the start, or on the best route; false if its walk is already known.
  bool set_out(const Shift& shift, Ant& ant, Slot& slot) const {
    ant.restart();
    if (options_.repeat_best && ant.index == 0 && shift.best.arrived()) {
      const std::size_t index = ant.index;
      ant = shift.best;
      ant.index = index;
      return false;
    }
    slot.ant = &ant;
    slot.stream = Stream(shift.run.seed(), shift.run.iterations(), ant.index);
    slot.moves = 0;
    slot.at.cell = space_.start();
    slot.at.came = GridSpace::kNoDirection;
    slot.left = std::numeric_limits<float>::infinity();
    visit(slot);
    if (!shift.best.arrived()) return true;
    if (options_.give_up > 0) slot.left = static_cast<float>(shift.best.sum * (1 + options_.give_up));
    if (slot.stream.uniform() < options_.follow) follow(shift.best, slot);
    return true;
  }

  void follow(const Ant& best, Slot& slot) const {
    const std::size_t moves = slot.stream.below(best.actions.size());
    for (std::size_t i = 0; i < moves; ++i) move(slot, best.actions[i]);
  }

  void move(Slot& slot, unsigned direction) const {
    slot.path[slot.moves++] = static_cast<std::uint32_t>(MoveCells::key(slot.at.cell, direction));
    slot.at.cell += static_cast<GridSpace::Cell>(offsets_[direction]);
    slot.at.came = direction;
    slot.left -= cost_[direction];
    visit(slot);
  }

  /// Tells the neighbours of the ant's cell that it is tabu, a row of three at once; the fourth byte stays.
  void visit(Slot& slot) const {
    constexpr auto kSouthRow = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{1U << 1U, 1U << 2U, 1U << 3U});
    constexpr auto kOwnRow = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{1U << 0U, 0, 1U << 4U});
    constexpr auto kNorthRow = std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{1U << 7U, 1U << 6U, 1U << 5U});
    const std::ptrdiff_t stride = stride_;
    std::uint8_t* west = slot.tabu.data() + slot.at.cell - 1;
    mark(west - stride, kNorthRow);
    mark(west, kOwnRow);
    mark(west + stride, kSouthRow);
  }
  static void mark(std::uint8_t* row, std::uint32_t bits) {
    std::uint32_t four = 0;
    std::memcpy(&four, row, sizeof four);
    four |= bits;
    std::memcpy(row, &four, sizeof four);
  }
  /// Wipes what all neighbours were told, and one cell more: walks end as a whole.
  void wipe(Slot& slot, GridSpace::Cell cell) const {
    constexpr std::uint32_t kNothing = 0;
    const std::ptrdiff_t stride = stride_;
    std::uint8_t* west = slot.tabu.data() + cell - 1;
    for (std::uint8_t* row : {west - stride, west, west + stride}) std::memcpy(row, &kNothing, sizeof kNothing);
  }

  /// One move; false at the end of the walk.
  [[gnu::always_inline]] bool step(const Shift& shift, Slot& slot) const {
    slot.at.tabu = slot.tabu[slot.at.cell];
    const unsigned direction = shift.policies.choice(slot.at, slot.stream);
    if (direction == GridSpace::kNoDirection) return step_back(slot);
    move(slot, direction);
    return slot.at.cell != space_.goal() && slot.left >= ahead_[slot.at.cell];
  }

  bool step_back(Slot& slot) const {
    if (slot.moves == 0 || slot.dead.size() >= options_.step_backs) return false;
    slot.dead.push_back(slot.at.cell);
    const std::uint32_t taken = slot.path[--slot.moves];
    slot.at.cell = taken / GridSpace::kDirections;
    slot.left += cost_[taken % GridSpace::kDirections];
    slot.at.came =
        slot.moves > 0 ? slot.path[slot.moves - 1] % GridSpace::kDirections : unsigned{GridSpace::kNoDirection};
    return true;
  }

  /// Writes the walk down and wipes its traces.
  void finish(const Shift& shift, Slot& slot) const {
    Ant& ant = *slot.ant;
    ant.keys.resize(slot.moves);
    ant.actions.resize(slot.moves);
    std::size_t diagonals = 0;
    for (std::size_t i = 0; i < slot.moves; ++i) {
      const std::uint32_t move = slot.path[i];
      ant.keys[i] = move;
      ant.actions[i] = move % GridSpace::kDirections;
      diagonals += move % 2;
      wipe(slot, move / GridSpace::kDirections);
    }
    wipe(slot, slot.at.cell);
    for (const GridSpace::Cell cell : slot.dead) wipe(slot, cell);
    slot.dead.clear();
    ant.sum = space_.length(slot.moves, diagonals);
    if (slot.at.cell == space_.goal())
      ant.cost = space_.rule().length_only() ? ant.sum * space_.rule().length : space_.score(ant.actions);
    count_known(shift.policies, ant);
  }

  static void count_known(const Policies& policies, Ant& ant) {
    const auto known = [&](TrailKey move) { return policies.trail.known(move); };
    ant.known = static_cast<std::size_t>(std::ranges::count_if(ant.keys, known));
  }

  std::array<float, GridSpace::kDirections> step_costs() const {
    std::array<float, GridSpace::kDirections> costs{};
    for (unsigned d = 0; d < GridSpace::kDirections; ++d) costs[d] = static_cast<float>(space_.step(d));
    return costs;
  }

  const GridSpace& space_;
  Options options_;
  std::vector<Group> groups_;
  std::array<std::int32_t, GridSpace::kDirections> offsets_;
  std::ptrdiff_t stride_;     ///< From a cell to the one south of it.
  std::vector<float> ahead_;  ///< Least length from a cell to the goal.
  std::array<float, GridSpace::kDirections> cost_ = step_costs();
};

/// `Choice` draws the moves: heuristic and transition in one, with tables by cell.
template <class Choice, class DepositPolicy, class LocalSearch>
struct GridPolicies {
  template <class Space>
  using Walk = GridWalk<GridPolicies>;

  Choice choice;
  Trail<MoveCells> trail;
  DepositPolicy deposit;
  LocalSearch local_search;
};

}  // namespace alate
