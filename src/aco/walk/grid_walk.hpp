// Ants on a grid, four side by side (lanes.hpp), and eight on the way: while four wait for their numbers, the others
// step.
//
// Source: alate. Every ant draws from its own Stream and reads tables that nobody changes, so who walks beside whom
// does not show. Cost: 9 ns a step where a table holds the choices, 15 ns where they are worked out.
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
#include <span>
#include <vector>

#include "aco/ant.hpp"
#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/walk/lanes.hpp"
#include "alate/core/run_context.hpp"
#include "alate/core/stream.hpp"
#include "space/height_grid.hpp"
#include "space/simd.hpp"

namespace alate {

struct GridWalkOptions {
  std::size_t ants = 50;
  std::uint64_t iterations = 30;  ///< Where neither a budget nor a time limit is given.
  double follow = 0;              ///< Share of ants that begin with a part of the best route.
  double give_up = 0;             ///< An ant that will be longer than the best by this share ends; 0: never.
  std::size_t step_backs = 0;     ///< Of one ant, at most.
  bool repeat_best = false;
};

template <class Policies>
class GridWalk {
 public:
  using Options = GridWalkOptions;

  GridWalk(const GridSpace& space, const Options& options)
      : space_(space),
        options_(options),
        offsets_(space.offsets()),
        stride_(offsets_[6]),
        gives_up_(options.give_up > 0) {
    for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
      ahead_.push_back(static_cast<float>(space.octile(cell, space.goal())));
  }

  void operator()(Policies& policies, std::vector<Ant>& ants, const Ant& best, RunContext& run) {
    policies.choice.prepare(policies.trail);
    if (groups_.empty()) make_groups(static_cast<std::size_t>(run.executor().threads()));
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
  static constexpr std::size_t kSlots = 8;  ///< Ants of a group at once.
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
    GridSpace::Cell cell = 0;
    unsigned came = GridSpace::kNoDirection;
    std::size_t moves = 0;
    Stream stream{0, 0, 0};
    Ant* ant = nullptr;
    float left = 0;  ///< Length until it gives up.
    std::size_t step_backs = 0;
    std::uint8_t mark = 0;            ///< What cells have that this ant visited.
    std::vector<std::uint8_t> marks;  ///< Those of earlier ants stay until all marks are used up.
    std::vector<std::uint32_t> path;  ///< Moves: 8 cell + direction.

    void resize(std::size_t cells) {
      path.resize(cells);
      marks.resize(cells + 3);
    }
    void clear() {
      moves = 0;
      step_backs = 0;
      if (++mark != 0) return;
      std::ranges::fill(marks, std::uint8_t{0});
      mark = 1;
    }
    void visit(GridSpace::Cell at) { marks[cell = at] = mark; }
  };
  struct Group {
    std::array<Slot, kSlots> slots;
    Slot idle;  ///< Fills up lanes; never walks.
  };
  /// Who of a group is on the way, and who has not set out. Lanes beyond `count` are idle.
  struct Crew {
    std::array<Slot*, kSlots + 1> active{};  // the last is idle
    std::size_t count = 0;
    std::size_t next = 0, last = 0;  ///< Of the ants.
  };

  /// One for each thread, unless their lanes could not be filled.
  void make_groups(std::size_t threads) {
    groups_.resize(std::clamp<std::size_t>(options_.ants / kSlots, 1, threads));
    for (Group& group : groups_) {
      for (Slot& slot : group.slots) slot.resize(space_.cells());
      group.idle.resize(space_.cells());
      group.idle.cell = space_.start();
    }
  }

  std::size_t first_of(const Shift& shift, std::size_t group) const {
    return group * shift.ants.size() / groups_.size();
  }

  ALATE_SIMD void walk(const Shift& shift, std::size_t group) {
    Crew crew{.next = first_of(shift, group), .last = first_of(shift, group + 1)};
    crew.active.fill(&groups_[group].idle);
    for (Slot& slot : groups_[group].slots)
      if (seat(shift, crew, slot)) crew.active[crew.count++] = &slot;
    for (std::size_t round = 0; crew.count > 0; ++round) {
      if (round % kPollEvery == 0 && !shift.run.keep_going()) break;
      step(shift, crew);
    }
    for (std::size_t i = 0; i < crew.count; ++i) finish(shift, *crew.active[i]);
    for (; crew.next < crew.last; ++crew.next) shift.ants[crew.next].restart();
  }

  /// The next ant sets out in a slot; false if there is none.
  bool seat(const Shift& shift, Crew& crew, Slot& slot) const {
    while (crew.next < crew.last)
      if (set_out(shift, shift.ants[crew.next++], slot)) return true;
    return false;
  }

  /// One move of all. The last comes first, so that whoever takes an empty place has moved.
  [[gnu::always_inline]] void step(const Shift& shift, Crew& crew) const {
    std::array<std::uint32_t, kSlots> direction{};
    for (std::size_t lane = 0; lane < crew.count; lane += kAntLanes) {
      const auto slots = std::span(crew.active).subspan(lane).template first<kAntLanes>();
      const LaneStreams streams{&slots[0]->stream, &slots[1]->stream, &slots[2]->stream, &slots[3]->stream};
      const LaneBits drawn = shift.policies.choice(look(slots), streams);
      std::memcpy(&direction[lane], &drawn, sizeof drawn);
    }
    for (std::size_t i = crew.count; i-- > 0;) {
      Slot& slot = *crew.active[i];
      if (go(slot, direction[i])) continue;
      finish(shift, slot);
      if (seat(shift, crew, slot)) continue;
      crew.active[i] = crew.active[--crew.count];
      crew.active[crew.count] = crew.active[kSlots];
    }
  }

  [[gnu::always_inline]] GridStands look(std::span<Slot* const, kAntLanes> slots) const {
    const auto each = [slots](const auto& see) {
      return LaneBits{see(*slots[0]), see(*slots[1]), see(*slots[2]), see(*slots[3])};
    };
    const auto row = [&](std::ptrdiff_t down) {
      return each([west = down * stride_ - 1](const Slot& slot) {
        std::int32_t four = 0;
        std::memcpy(&four, slot.marks.data() + slot.cell + west, sizeof four);
        return four;
      });
    };
    return {.cell = {slots[0]->cell, slots[1]->cell, slots[2]->cell, slots[3]->cell},
            .came = {slots[0]->came, slots[1]->came, slots[2]->came, slots[3]->came},
            .mark = each([](const Slot& slot) { return static_cast<std::int32_t>(slot.mark * 0x01010101U); }),
            .marks = {row(-1), row(0), row(1)}};
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
    slot.clear();
    slot.visit(space_.start());
    slot.came = GridSpace::kNoDirection;
    slot.left = std::numeric_limits<float>::infinity();
    if (!shift.best.arrived()) return true;
    if (gives_up_) slot.left = static_cast<float>(shift.best.sum * (1 + options_.give_up));
    if (slot.stream.uniform() < options_.follow) follow(shift.best, slot);
    return true;
  }

  void follow(const Ant& best, Slot& slot) const {
    const std::size_t moves = slot.stream.below(best.actions.size());
    for (std::size_t i = 0; i < moves; ++i) move(slot, best.actions[i]);
  }

  void move(Slot& slot, unsigned direction) const {
    slot.path[slot.moves++] = static_cast<std::uint32_t>(MoveCells::key(slot.cell, direction));
    slot.visit(slot.cell + static_cast<GridSpace::Cell>(offsets_[direction]));
    slot.came = direction;
    if (gives_up_) slot.left -= cost_[direction];
  }

  /// False at the end of the walk.
  [[gnu::always_inline]] bool go(Slot& slot, unsigned direction) const {
    if (direction == GridSpace::kNoDirection) return step_back(slot);
    move(slot, direction);
    return slot.cell != space_.goal() && (!gives_up_ || slot.left >= ahead_[slot.cell]);
  }

  bool step_back(Slot& slot) const {
    if (slot.moves == 0 || slot.step_backs >= options_.step_backs) return false;
    ++slot.step_backs;
    const std::uint32_t taken = slot.path[--slot.moves];
    slot.cell = taken / GridSpace::kDirections;
    slot.left += cost_[taken % GridSpace::kDirections];
    slot.came = slot.moves > 0 ? slot.path[slot.moves - 1] % GridSpace::kDirections : unsigned{GridSpace::kNoDirection};
    return true;
  }

  /// Writes the walk down.
  void finish(const Shift& shift, const Slot& slot) const {
    Ant& ant = *slot.ant;
    ant.keys.assign(slot.path.begin(), slot.path.begin() + static_cast<std::ptrdiff_t>(slot.moves));
    ant.actions.resize(slot.moves);
    std::size_t diagonals = 0;
    for (std::size_t i = 0; i < slot.moves; ++i) {
      ant.actions[i] = slot.path[i] % GridSpace::kDirections;
      diagonals += slot.path[i] % 2;
    }
    ant.sum = space_.length(slot.moves, diagonals);
    if (slot.cell == space_.goal())
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
  std::ptrdiff_t stride_;  ///< From a cell to the one south of it.
  bool gives_up_;
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
