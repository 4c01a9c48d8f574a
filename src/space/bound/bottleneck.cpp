#include "space/bound/bottleneck.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "space/bound/passage.hpp"

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSmallestCell_m = 1e-3;
constexpr std::size_t kPollEvery = 256;

class MinimaxSearch {
 public:
  MinimaxSearch(const Problem& problem, const BottleneckOptions& options)
      : problem_(problem),
        site_(problem.world.site()),
        air_(site_, options.voids),
        passage_(problem),
        area_(air_.area()) {
    const Vec2 extent = area_.max - area_.min;
    const auto* raster = std::get_if<HeightRaster>(&site_.ground);
    cell_m_ = std::max({std::sqrt(extent.x() * extent.y() / options.most_cells), extent.maxCoeff() / options.most_cells,
                        raster != nullptr ? raster->cell_m : kSmallestCell_m});
    columns_ = std::max(1, static_cast<int>(std::ceil(extent.x() / cell_m_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(extent.y() / cell_m_)));
    open_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNotSeen);
    settled_.assign(open_.size(), 0);
  }

  Bottleneck run(RunContext& context) {
    begin();
    for (std::size_t pops = 1; !queue_.empty(); ++pops) {
      if (pops % kPollEvery == 0 && !context.keep_going()) return result_;
      const Queued top = queue_.top();
      queue_.pop();
      if (std::exchange(settled_[static_cast<std::size_t>(top.cell)], 1) != 0) continue;
      result_.cost = std::max(result_.cost, top.price);
      note_nearest(top.cell);
      if (passage_.ends_at(box(top.cell), open(top.cell))) return result_;
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
    const Vec2 at = (start.head<2>() - area_.min) / cell_m_;
    const int column = std::clamp(static_cast<int>(at.x()), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(at.y()), 0, rows_ - 1);
    const int cell = row * columns_ + column;
    nearest_m_ = kInfinity;
    if (open(cell).overlap({.low = start.z(), .high = start.z()})) queue_.push({0, cell});
    note_nearest(cell);
  }

  Box2 box(int cell) const {
    const Vec2 corner = area_.min + cell_m_ * Vec2(cell % columns_, cell / columns_);
    return {.min = corner, .max = corner + Vec2::Constant(cell_m_)};
  }

  const Altitudes& open(int cell) {
    Altitudes& known = open_[static_cast<std::size_t>(cell)];
    if (std::isnan(known.low)) known = air_.over(box(cell));
    return known;
  }

  void spread(int cell) {
    const int column = cell % columns_;
    const int row = cell / columns_;
    const Box2 here = box(cell);
    const Vec2 lower_right(here.max.x(), here.min.y());
    const Vec2 upper_left(here.min.x(), here.max.y());
    if (column > 0) cross({.min = here.min, .max = upper_left}, cell - 1);
    if (column + 1 < columns_) cross({.min = lower_right, .max = here.max}, cell + 1);
    if (row > 0) cross({.min = here.min, .max = lower_right}, cell - columns_);
    if (row + 1 < rows_) cross({.min = upper_left, .max = here.max}, cell + columns_);
  }

  /// Who passes through a corner crosses two sides there.
  void cross(const Box2& side, int next) {
    if (settled_[static_cast<std::size_t>(next)] != 0 || !open(next).any()) return;
    const Altitudes on_side = air_.along(side.min, side.max);
    if (on_side.any()) queue_.push({passage_.price(side, on_side), next});
  }

  void note_nearest(int cell) {
    const Box2 square = box(cell);
    const Vec2 middle = (square.min + square.max) / 2;
    const double distance = (middle - problem_.mission.goal.head<2>()).norm();
    if (!(distance < nearest_m_)) return;
    nearest_m_ = distance;
    result_.nearest = middle;
  }

  bool is_goal_open() {
    for (int cell = 0; cell < columns_ * rows_; ++cell) {
      const Box2 square = box(cell);
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
  Box2 area_;
  double cell_m_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  double nearest_m_ = kInfinity;
  Bottleneck result_;
  std::vector<Altitudes> open_;
  std::vector<char> settled_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
};

}  // namespace

Bottleneck bottleneck(const Problem& problem, const BottleneckOptions& options, RunContext& run) {
  return MinimaxSearch(problem, options).run(run);
}

}  // namespace alate
