#include "search/voxel/voxel_theta.hpp"

#include <algorithm>
#include <cmath>

#include "search/voxel/line_of_sight.hpp"

namespace alate {

namespace {

VoxelCost rounded(double length) { return static_cast<VoxelCost>(std::llround(length)); }

double length_of(const std::vector<VoxelPlace>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += line_length(way[i - 1], way[i]);
  return length;
}

}  // namespace

/// A cell that does not see its parent takes the best of its neighbours that were expanded; that which came to it is
/// one.
void VoxelTheta::settle(VoxelPlace place, VoxelMoves::Set free) {
  VoxelThetaRecord known = costs_.record(grid_.cell(place));
  if (!is_in_sight(grid_, known.parent, place)) {
    known.key = PagedTable<VoxelThetaRecord>::kNothing;
    for (; free != 0; free &= free - 1) {
      const auto d = static_cast<unsigned>(std::countr_zero(free));
      const VoxelPlace next = moved(place, d);
      if (!costs_.known(grid_.cell(next))) continue;
      const VoxelThetaRecord& other = costs_.record(grid_.cell(next));
      if (!other.closed || other.key + VoxelMoves::cost(d) >= known.key) continue;
      known.key = other.key + VoxelMoves::cost(d);
      known.parent = next;
    }
  }
  known.closed = true;
  costs_.record(grid_.cell(place)) = known;
}

void VoxelTheta::expand(VoxelPlace place, VoxelMoves::Set free) {
  const VoxelPlace parent = costs_.record(grid_.cell(place)).parent;
  const VoxelCost before = costs_.record(grid_.cell(parent)).key;
  for (; free != 0; free &= free - 1) {
    const VoxelPlace next = moved(place, static_cast<unsigned>(std::countr_zero(free)));
    VoxelThetaRecord& known = costs_.record(grid_.cell(next));
    const VoxelCost key = before + rounded(line_length(parent, next));
    if (known.closed || key >= known.key) continue;
    known.key = key;
    known.parent = parent;
    open_.push(key + rounded(line_length(next, goal_)), {key, next});
  }
}

/// False if the run was stopped. The goal can be reached.
bool VoxelTheta::search(VoxelPlace start, VoxelPlace goal, RunContext& run) {
  goal_ = goal;
  costs_.begin_query();
  costs_.record(grid_.cell(start)) = {.key = 0, .parent = start};
  open_.clear(rounded(line_length(start, goal)));
  open_.push(rounded(line_length(start, goal)), {0, start});
  while (!open_.empty()) {
    const Entry entry = open_.pop();
    const VoxelThetaRecord& known = costs_.record(grid_.cell(entry.place));
    if (known.closed || known.key != entry.key) continue;
    if (expansions_ % kPollEvery == 0 && !run.keep_going()) return false;
    ++expansions_;
    const VoxelMoves::Set free = moves(entry.place);
    settle(entry.place, free);
    if (entry.place == goal) return true;
    expand(entry.place, free);
  }
  return false;
}

VoxelTheta::Way VoxelTheta::trace(VoxelPlace start, VoxelPlace goal) const {
  Way way{goal};
  while (way.back() != start) way.push_back(costs_.record(grid_.cell(way.back())).parent);
  std::ranges::reverse(way);
  return way;
}

/// From each place on straight to the last of the following that is in sight.
VoxelTheta::Way VoxelTheta::cut_short(const Way& way) const {
  Way taut{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t last = way.size() - 1;
    while (last > i + 1 && !is_in_sight(grid_, way[i], way[last])) --last;
    taut.push_back(way[last]);
    i = last;
  }
  return taut;
}

VoxelWay VoxelTheta::find(VoxelPlace start, VoxelPlace goal, RunContext& run) {
  VoxelWay way = jps_.find(start, goal, run);
  way.length = {};
  if (!way.found) return way;
  way.corners = cut_short(way.corners);
  if (!way.finished || way.corners.size() < 3) return way;
  expansions_ = 0;
  way.finished = search(start, goal, run);
  if (way.finished) {
    const Way other = cut_short(trace(start, goal));
    if (length_of(other) < length_of(way.corners)) way.corners = other;
  }
  way.expansions += expansions_;
  return way;
}

}  // namespace alate
