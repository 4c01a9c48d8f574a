#include "aco/local_search/sight.hpp"

#include <algorithm>
#include <cstdlib>

namespace alate {

namespace {

/// The steps of a shortest connection on free cells: so many straight ones, so many diagonal ones.
struct Steps {
  unsigned straight = 0;
  unsigned diagonal = 0;
  std::size_t straights = 0;
  std::size_t diagonals = 0;
};

unsigned direction_of(int across, int along) {
  unsigned direction = 0;
  while (GridSpace::shift(direction) != std::array{across, along}) ++direction;
  return direction;
}

int sign(int value) { return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0); }

Steps steps_between(const GridSpace& space, GridSpace::Cell from, GridSpace::Cell to) {
  const int across = space.column(to) - space.column(from);
  const int along = space.row(to) - space.row(from);
  const int both = std::min(std::abs(across), std::abs(along));
  Steps steps{.straights = static_cast<std::size_t>(std::max(std::abs(across), std::abs(along)) - both),
              .diagonals = static_cast<std::size_t>(both)};
  if (both > 0) steps.diagonal = direction_of(sign(across), sign(along));
  if (steps.straights > 0)
    steps.straight = std::abs(across) > std::abs(along) ? direction_of(sign(across), 0) : direction_of(0, sign(along));
  return steps;
}

}  // namespace

bool Sight::operator()(const GridSpace& space, Ant& ant, double /*best*/, RunContext& run) {
  if (!space.rule().length_only()) return false;
  moves_.assign(ant.actions.begin(), ant.actions.end());
  bool changed = false;
  while (run.keep_going() && shorten(space)) changed = true;
  if (!changed) return false;
  ant.actions.assign(moves_.begin(), moves_.end());
  ant.cost = space.score(ant.actions);
  return true;
}

/// One sweep over the route.
bool Sight::shorten(const GridSpace& space) {
  cells_.assign(1, space.start());
  until_.assign(1, 0);
  for (const std::uint32_t d : moves_) {
    cells_.push_back(space.neighbour(cells_.back(), d));
    until_.push_back(until_.back() + space.step(d));
  }
  bool changed = false;
  for (std::size_t first = 0; first + 2 < cells_.size(); ++first) changed = shorten_from(space, first) || changed;
  return changed;
}

bool Sight::shorten_from(const GridSpace& space, std::size_t first) {
  constexpr double kHair = 1e-9;
  for (std::size_t last = std::min(first + reach_, moves_.size()); last > first + 1; --last) {
    const double shortest = space.octile(cells_[first], cells_[last]);
    if (until_[last] - until_[first] <= shortest + kHair) continue;
    if (!connect(space, cells_[first], cells_[last])) continue;
    splice(space, first, last);
    return true;
  }
  return false;
}

/// First diagonally, then straight, or the other way round.
bool Sight::connect(const GridSpace& space, Cell from, Cell to) {
  const Steps steps = steps_between(space, from, to);
  const auto lead_on = [&](std::size_t count, unsigned direction) { bridge_.insert(bridge_.end(), count, direction); };
  bridge_.clear();
  lead_on(steps.diagonals, steps.diagonal);
  lead_on(steps.straights, steps.straight);
  if (is_free(space, from)) return true;
  std::ranges::rotate(bridge_, bridge_.begin() + static_cast<std::ptrdiff_t>(steps.diagonals));
  return is_free(space, from);
}

/// May the bridge be walked?
bool Sight::is_free(const GridSpace& space, Cell cell) const {
  return std::ranges::all_of(bridge_, [&](std::uint32_t direction) {
    const bool free = ((space.open(cell) >> direction) & 1U) != 0;
    cell = space.neighbour(cell, direction);
    return free;
  });
}

/// Puts the bridge in the place of the moves from `first` to `last`.
void Sight::splice(const GridSpace& space, std::size_t first, std::size_t last) {
  const auto at = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
  moves_.insert(moves_.erase(at(moves_, first), at(moves_, last)), bridge_.begin(), bridge_.end());
  cells_.resize(first + 1);
  until_.resize(first + 1);
  for (std::size_t i = first; i < moves_.size(); ++i) {
    cells_.push_back(space.neighbour(cells_[i], moves_[i]));
    until_.push_back(until_[i] + space.step(moves_[i]));
  }
}

}  // namespace alate
