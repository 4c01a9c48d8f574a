#include "plan/grid/voxel_plan.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <optional>

#include "plan/grid/grid_plan.hpp"

namespace alate {

namespace {

/// The free cell whose middle `place` is.
std::optional<VoxelCell> cell_of(const VoxelGrid& voxels, const Vec3& place) {
  constexpr double kHair = 1e-9;
  const auto cell = voxels.cell_at(place);
  if (!cell || voxels.blocked_at(*cell)) return std::nullopt;
  if ((voxels.center(*cell) - place).norm() > kHair * voxels.cell_m) return std::nullopt;
  return cell;
}

/// Cells that steps lead to from one end: as diagonal steps need all cells of their box free, those across faces reach
/// as many.
class Flood {
 public:
  Flood(const VoxelGrid& voxels, const VoxelCell& from) : voxels_(voxels), reached_(voxels.size()), front_{from} {
    reached_.block(from);
  }

  bool done() const { return front_.empty(); }
  std::size_t count() const { return count_; }
  void step() {
    const VoxelCell cell = front_.back();
    front_.pop_back();
    ++count_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int by : {-1, 1}) {
        VoxelCell next = cell;
        next.at(axis) += by;
        if (!voxels_.is_free(next) || reached_.blocked_at(next)) continue;
        reached_.block(next);
        front_.push_back(next);
      }
    }
  }
  /// Of the cells reached, the first of those nearest to `place`.
  VoxelCell nearest_to(const VoxelCell& place) const {
    VoxelCell nearest{};
    double least = kInfinity;
    reached_.for_each_blocked([&](const VoxelCell& cell) {
      const double distance = (reached_.center(cell) - reached_.center(place)).norm();
      if (distance >= least) return;
      least = distance;
      nearest = cell;
    });
    return nearest;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  const VoxelGrid& voxels_;
  VoxelGrid reached_;  ///< Blocked there: reached.
  std::vector<VoxelCell> front_;
  std::size_t count_ = 0;
};

}  // namespace

std::string voxel_refusal(const Problem& problem) {
  const VoxelGrid& voxels = *problem.world.site().voxels;
  if (!cell_of(voxels, problem.mission.start) || !cell_of(voxels, problem.mission.goal))
    return "starts and ends in the middle of free cells; give start.cell and goal.cell";
  if (problem.vehicle.climb_rad || problem.vehicle.descent_rad)
    return "steps straight up and down as well, which limits of climb forbid; leave out vehicle.climb_deg and "
           "vehicle.descent_deg";
  if (problem.objective.climb > 0)
    return "looks for the shortest route, whatever it climbs; set objective.climb to 0, or leave it out";
  return step_refusal(problem);
}

VoxelEnds voxel_ends(const Problem& problem) {
  const VoxelGrid& voxels = *problem.world.site().voxels;
  return {VoxelBits::place(*cell_of(voxels, problem.mission.start)),
          VoxelBits::place(*cell_of(voxels, problem.mission.goal))};
}

double VoxelToVoxel::least_length(const Problem& problem) {
  constexpr double kHair = 1e-12;  // a sum of legs in another order
  const auto [start, goal] = voxel_ends(problem);
  const auto cost = VoxelSpace<void>::distance(start, goal);
  return problem.world.site().voxels->cell_m * static_cast<double>(cost) / static_cast<double>(kVoxelStraight) *
         (1 - kHair);
}

double VoxelLines::least_length(const Problem& problem) {
  constexpr double kHair = 1e-12;  // a sum of legs
  return (problem.mission.goal - problem.mission.start).norm() * (1 - kHair);
}

std::vector<Vec3> VoxelLegs::places(const Problem& problem, const VoxelBits& /*cells*/, const VoxelWay& way) {
  std::vector<Vec3> places;
  places.reserve(way.corners.size());
  for (const VoxelPlace corner : way.corners)
    places.push_back(problem.world.site().voxels->center(VoxelBits::cell_of(corner)));
  return places;
}

/// From both ends at once, so that a small room is soon known as one.
std::string VoxelLegs::no_way(const Problem& problem) {
  const VoxelGrid& voxels = *problem.world.site().voxels;
  const auto [start, goal] = voxel_ends(problem);
  Flood from_start(voxels, VoxelBits::cell_of(start));
  Flood from_goal(voxels, VoxelBits::cell_of(goal));
  while (!from_start.done() && !from_goal.done()) {
    from_start.step();
    from_goal.step();
  }
  const bool at_start = from_start.done();
  const Flood& room = at_start ? from_start : from_goal;
  const VoxelCell nearest = room.nearest_to(VoxelBits::cell_of(at_start ? goal : start));
  return fmt::format(
      "blocked cells part the start from the goal: moves from the {} reach {} cells only, of which [{}, {}, {}] is the "
      "nearest to the {}",
      at_start ? "start" : "goal", room.count(), nearest[0], nearest[1], nearest[2], at_start ? "goal" : "start");
}

}  // namespace alate
