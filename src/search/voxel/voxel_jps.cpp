#include "search/voxel/voxel_jps.hpp"

#include <algorithm>

namespace alate {

namespace {

/// Steps in a direction along an axis from one place to another; 0 if it does not lie there.
unsigned steps_to(VoxelPlace from, VoxelPlace to, unsigned direction) {
  const auto& [x, y, z] = kVoxelShifts[direction];
  const int steps = (to.x - from.x) * x + (to.y - from.y) * y + (to.z - from.z) * z;
  return steps > 0 && moved(from, direction, steps) == to ? static_cast<unsigned>(steps) : 0;
}

}  // namespace

VoxelJps::VoxelJps(const VoxelBits& grid) : GridBestFirst(grid, widest_spread(grid)), moves_(VoxelMoves::table()) {}

/// False if the cell is known to cost less, or to have been come to in the same way.
bool VoxelJps::note(const Origin& at, unsigned direction, unsigned steps) {
  VoxelJumpRecord& known = costs_.record(grid_.cell(at.place));
  if (at.key > known.key) return false;
  const VoxelMoves::Set side = VoxelMoves::Set{1} << direction;
  if (at.key == known.key) {
    const bool again = (known.entered & side) != 0;
    known.entered |= side;
    return !again;
  }
  known = {.key = at.key,
           .entered = side,
           .steps = static_cast<std::uint16_t>(steps),
           .direction = static_cast<std::uint8_t>(direction)};
  return true;
}

void VoxelJps::run_straight(const Origin& origin, unsigned direction) {
  const VoxelBits::Run run = grid_.run(origin.place, direction);
  unsigned steps = run.turns ? run.steps : 0;
  const unsigned goal = steps_to(origin.place, goal_, direction);
  if (goal > 0 && goal <= run.steps) steps = goal;
  if (steps == 0) return;
  const Origin at{origin.key + steps * kVoxelStraight, moved(origin.place, direction, static_cast<int>(steps))};
  if (is_too_dear(at.key + to_goal(at.place)) || !note(at, direction, steps)) return;
  come_to({at.key, at.place, static_cast<std::uint8_t>(direction)});
}

/// Where no wall is near. Runs across edges wait in the queue, so that one across corners first comes as near to the
/// goal as it can.
void VoxelJps::branch_off(const Origin& origin, unsigned direction) {
  for (VoxelMoves::Set side = moves_.natural(direction) & ~(VoxelMoves::Set{1} << direction); side != 0;
       side &= side - 1) {
    const auto d = static_cast<unsigned>(std::countr_zero(side));
    if (kVoxelKinds[d] == 1) {
      run_straight(origin, d);
    } else {
      put_off({origin.key, origin.place, static_cast<std::uint8_t>(d), true},
              VoxelMoves::cost(d) + to_goal(moved(origin.place, d)));
    }
  }
}

void VoxelJps::run_diagonally(Origin origin, unsigned direction) {
  for (;;) {
    origin.place = moved(origin.place, direction);
    origin.key += VoxelMoves::cost(direction);
    const VoxelCost f = origin.key + to_goal(origin.place);
    if (is_too_dear(f) || !note(origin, direction, 1)) return;
    if (f > level_ || origin.place == goal_ || grid_.is_beside_wall(origin.place))
      return come_to({origin.key, origin.place, static_cast<std::uint8_t>(direction)});
    branch_off(origin, direction);
  }
}

void VoxelJps::follow(const Origin& origin, unsigned direction) {
  if (kVoxelKinds[direction] == 1) {
    run_straight(origin, direction);
  } else {
    run_diagonally(origin, direction);
  }
}

void VoxelJps::expand(const VoxelJump& entry) {
  const Origin origin{entry.key, entry.place};
  level_ = open_level();
  if (entry.run) return follow(origin, entry.direction);
  if (entry.direction != kNoVoxelDirection && !grid_.is_beside_wall(entry.place)) {
    branch_off(origin, entry.direction);
    return follow(origin, entry.direction);
  }
  VoxelMoves::Set next = moves_.successors(entry.direction, grid_.around(entry.place));
  for (; next != 0; next &= next - 1) follow(origin, static_cast<unsigned>(std::countr_zero(next)));
}

/// Back from each cell to that from which it was come to at its cost.
void VoxelJps::trace(VoxelWay& way) const {
  way.found = true;
  way.corners.push_back(goal_);
  while (way.corners.back() != start_) {
    const VoxelJumpRecord& known = costs_.record(grid_.cell(way.corners.back()));
    add_steps_before(way, known.direction, known.steps);
  }
  std::ranges::reverse(way.corners);
}

}  // namespace alate
