#include "search/voxel/voxel_moves.hpp"

#include <algorithm>
#include <optional>

namespace alate {

namespace {

using Set = VoxelMoves::Set;
using Shift = std::array<int, 3>;

Shift sum(const Shift& a, const Shift& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Shift opposite(const Shift& a) { return {-a[0], -a[1], -a[2]}; }

bool is_step(const Shift& shift) {
  return std::ranges::all_of(shift, [](int axis) { return axis >= -1 && axis <= 1; }) && shift != Shift{};
}

/// Cells of the box that a step from `from` spans, counted around the middle; nothing if one is not around it.
std::optional<Set> box(const Shift& from, const Shift& step) {
  Set cells = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Shift at = from;
    for (unsigned axis = 0; axis < 3; ++axis)
      if (((corner >> axis) & 1U) != 0) at.at(axis) += step.at(axis);
    if (std::ranges::any_of(at, [](int axis) { return axis < -1 || axis > 1; })) return std::nullopt;
    cells |= Set{1} << voxel_direction(at);
  }
  return cells;
}

/// Steps across corners first, then edges, then faces.
bool comes_before(unsigned a, unsigned b) {
  return kVoxelKinds.at(a) != kVoxelKinds.at(b) ? kVoxelKinds.at(a) > kVoxelKinds.at(b) : a < b;
}

/// Cells that must be free for each way of one or two steps from one cell around the middle to another which makes two
/// steps through the middle needless.
std::vector<Set> other_ways(unsigned came, unsigned next) {
  const Shift from = opposite(kVoxelShifts.at(came));
  const Shift way = sum(kVoxelShifts.at(came), kVoxelShifts.at(next));
  if (way == Shift{}) return {0};
  std::vector<Set> ways;
  if (is_step(way)) {
    if (const auto cells = box(from, way)) ways.push_back(*cells);
  }
  const VoxelCost cost = VoxelMoves::cost(came) + VoxelMoves::cost(next);
  for (unsigned first = 0; first < kVoxelDirections; ++first) {
    const Shift rest = sum(way, opposite(kVoxelShifts.at(first)));
    if (first == kNoVoxelDirection || first == came || !is_step(rest)) continue;
    const VoxelCost other = VoxelMoves::cost(first) + VoxelMoves::cost(voxel_direction(rest));
    if (other > cost || (other == cost && !comes_before(first, came))) continue;
    const auto before = box(from, kVoxelShifts.at(first));
    const auto behind = box(sum(from, kVoxelShifts.at(first)), rest);
    if (before && behind) ways.push_back(*before | *behind);
  }
  return ways;
}

}  // namespace

const VoxelMoves& VoxelMoves::table() {
  static const VoxelMoves kTable;
  return kTable;
}

VoxelMoves::VoxelMoves() {
  for (unsigned d = 0; d < kVoxelDirections; ++d)
    boxes_.at(d) = *box({}, kVoxelShifts.at(d)) & ~(Set{1} << kNoVoxelDirection);
  for (unsigned came = 0; came < kVoxelDirections; ++came) {
    for (unsigned next = 0; next < kVoxelDirections; ++next)
      if (next != kNoVoxelDirection) note_pair(came, next);
    natural_.at(came) = successors(came, 0);
  }
}

/// Of a way round only the cells count that are not free anyway; one that needs no others makes the pair needless.
void VoxelMoves::note_pair(unsigned came, unsigned next) {
  const auto first = static_cast<std::uint32_t>(ways_.size());
  bool always = false;
  if (came != kNoVoxelDirection) {
    const Shift from = opposite(kVoxelShifts.at(came));
    const Set known = *box(from, kVoxelShifts.at(came)) | *box({}, kVoxelShifts.at(next));
    for (const Set way : other_ways(came, next)) {
      always = always || (way & ~known) == 0;
      ways_.push_back(way & ~known);
    }
  }
  if (always) {
    ways_.resize(first);
  } else {
    candidates_.at(came) |= Set{1} << next;
  }
  ways_round_.at(came * kVoxelDirections + next) = {first, static_cast<std::uint32_t>(ways_.size())};
}

}  // namespace alate
