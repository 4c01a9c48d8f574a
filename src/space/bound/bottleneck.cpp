#include "space/bound/bottleneck.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "space/bound/cell_plane.hpp"
#include "space/bound/passage.hpp"

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kPollEvery = 256;

class MinimaxSearch {
 public:
  MinimaxSearch(const Problem& problem, const BottleneckOptions& options)
      : problem_(problem),
        site_(problem.world.site()),
        air_(site_, options.voids),
        passage_(problem),
        plane_(site_, air_.area(), options.most_cells),
        open_(plane_.size(), kNotSeen),
        settled_(plane_.size(), 0) {}

  Bottleneck run(RunContext& context) {
    begin();
    for (std::size_t pops = 1; !queue_.empty(); ++pops) {
      if (pops % kPollEvery == 0 && !context.keep_going()) return result_;
      const Queued top = queue_.top();
      queue_.pop();
      if (std::exchange(settled_[static_cast<std::size_t>(top.cell)], 1) != 0) continue;
      result_.cost = std::max(result_.cost, top.price);
      note_nearest(top.cell);
      if (passage_.ends_at(plane_.box(top.cell), open(top.cell))) return result_;
      spread(top.cell);
    }
    result_.barred = true;
    result_.at_goal = !is_goal_open();
    return result_;
  }

 private:
  struct Queued {
    double price;
    int cell;
    bool operator>(const Queued& other) const { return price != other.price ? price > other.price : cell > other.cell; }
  };
  static constexpr Altitudes kNotSeen{.low = std::numeric_limits<double>::quiet_NaN(), .high = 0};

  void begin() {
    const Vec3& start = problem_.mission.start;
    const int cell = plane_.cell_at(start.head<2>());
    nearest_m_ = kInfinity;
    result_.at_start = !open(cell).overlap({.low = start.z(), .high = start.z()});
    if (!result_.at_start) queue_.push({0, cell});
    note_nearest(cell);
  }

  const Altitudes& open(int cell) {
    Altitudes& known = open_[static_cast<std::size_t>(cell)];
    if (std::isnan(known.low)) known = air_.over(plane_.box(cell));
    return known;
  }

  void spread(int cell) {
    plane_.for_sides(cell, [&](const CellPlane::Side& side) { cross(side); });
  }

  /// Who passes through a corner crosses two sides there.
  void cross(const CellPlane::Side& side) {
    if (settled_[static_cast<std::size_t>(side.other)] != 0 || !open(side.other).any()) return;
    const Altitudes on_side = air_.along(side.line.min, side.line.max);
    if (on_side.any()) queue_.push({passage_.price(side.line, on_side), side.other});
  }

  void note_nearest(int cell) {
    const Box2 square = plane_.box(cell);
    const Vec2 middle = (square.min + square.max) / 2;
    const double distance = (middle - problem_.mission.goal.head<2>()).norm();
    if (!(distance < nearest_m_)) return;
    nearest_m_ = distance;
    result_.nearest = middle;
  }

  bool is_goal_open() {
    for (int cell = 0; cell < plane_.cells(); ++cell) {
      const Box2 square = plane_.box(cell);
      if (distance_to(square, problem_.mission.goal.head<2>()) <= problem_.mission.tolerance_m &&
          passage_.ends_at(square, open(cell)))
        return true;
    }
    return false;
  }

  const Problem& problem_;
  const Site& site_;
  OpenAir air_;
  Passage passage_;
  CellPlane plane_;
  std::vector<Altitudes> open_;
  std::vector<char> settled_;
  double nearest_m_ = kInfinity;
  Bottleneck result_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
};

}  // namespace

Bottleneck bottleneck(const Problem& problem, const BottleneckOptions& options, RunContext& run) {
  return MinimaxSearch(problem, options).run(run);
}

}  // namespace alate
