#include "space/lattice_frame.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "space/candidates.hpp"
#include "space/straight_limits.hpp"

namespace alate {

namespace {

/// Share of a cell by which rounding may miss the edge of the area.
constexpr double kHair = 1e-9;

int whole_down(double cells) { return static_cast<int>(std::floor(cells + kHair)); }
int whole_up(double cells) { return static_cast<int>(std::ceil(cells - kHair)); }

Box2 area_of(const Site& site) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return raster->area;
  return std::get<PeakGround>(site.ground).area;
}

/// A tilted raster does not fill its box; nor does one with voids. Those nodes have no ground.
double height_or_nan(const World& world, const Vec3& at) {
  return world.height(at.head<2>()).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

LatticeFrame::LatticeFrame(const World& world, const LatticeSteps& steps)
    : start_(world.site().mission.start),
      goal_(world.site().mission.goal),
      window_side_(steps.window_side),
      window_height_(steps.window_height) {
  lay_planes(steps);
  if (fault_.empty()) lay_columns(world);
  if (fault_.empty()) lay_levels(world, steps);
  if (fault_.empty()) note_moves(steps);
}

/// False where no plane lies between start and goal.
bool LatticeFrame::find_directions(MainDirection asked) {
  const Vec3 way = goal_ - start_;
  const bool x_is_longer = std::abs(way.x()) >= std::abs(way.y());
  main_ = asked;
  if (asked == MainDirection::automatic) main_ = x_is_longer ? MainDirection::x : MainDirection::y;
  ahead_ = Vec3(main_ == MainDirection::y ? 0 : way.x(), main_ == MainDirection::x ? 0 : way.y(), 0);
  if (!(ahead_.norm() > 0)) return false;
  ahead_.normalize();
  aside_ = main_ == MainDirection::x   ? Vec3(Vec3::UnitY())
           : main_ == MainDirection::y ? Vec3(Vec3::UnitX())
                                       : Vec3(-ahead_.y(), ahead_.x(), 0);
  return true;
}

void LatticeFrame::lay_planes(const LatticeSteps& steps) {
  constexpr double kPlanes = 50;
  if (!find_directions(steps.main)) {
    const std::string_view same = main_ == MainDirection::x ? "x" : main_ == MainDirection::y ? "y" : "x and y";
    fault_ = fmt::format("start and goal have the same {}: no plane of the lattice lies between them", same);
    return;
  }
  const double distance = along(goal_ - start_).x();
  const double step = steps.main_m > 0 ? steps.main_m : distance / kPlanes;
  const double planes = std::max(1.0, std::round(distance / step));
  if (is_too_large(planes, 1)) return;
  planes_ = static_cast<int>(planes);
  steps_m_.x() = distance / planes;
  steps_m_.y() = steps.side_m > 0 ? steps.side_m : steps.side_share * steps_m_.x();
}

bool LatticeFrame::is_too_large(double columns, double levels) {
  const double nodes = std::max(1, planes_) * columns * levels;
  if (nodes <= static_cast<double>(kMostNodes)) return false;
  fault_ =
      fmt::format("the lattice would have {:.0f} nodes, and at most {} are kept; take longer steps", nodes, kMostNodes);
  return true;
}

/// As far to both sides as the area and the window allow on a way that comes back in time.
void LatticeFrame::lay_columns(const World& world) {
  const Box2 area = area_of(world.site());
  double left = kInfinity;
  double right = -kInfinity;
  for (const double x : {area.min.x(), area.max.x()}) {
    for (const double y : {area.min.y(), area.max.y()}) {
      const double side = along(Vec3(x, y, 0) - start_).y() / steps_m_.y();
      left = std::min(left, side);
      right = std::max(right, side);
    }
  }
  const double across = along(goal_ - start_).y() / steps_m_.y();
  const double spare = std::max(0.0, (window_side_ * planes_ - std::abs(across)) / 2);
  const double low = std::max(left, std::min(0.0, across) - spare);
  const double high = std::min(right, std::max(0.0, across) + spare);
  if (is_too_large(high - low, 1)) return;
  first_column_ = std::min(0, whole_up(low));
  columns_ = std::max(0, whole_down(high)) - first_column_ + 1;
  for (int plane = 0; plane < planes_; ++plane)
    for (int column = 0; column < columns_; ++column)
      ground_.push_back(height_or_nan(world, position({plane, column, 0})));
}

/// From the lowest ground to the ceiling; without one two levels above all ground, start and goal.
void LatticeFrame::lay_levels(const World& world, const LatticeSteps& steps) {
  const Band& band = world.site().band;
  const double step = steps_m_.x();
  const double climb = StraightLimits(world.site()).slope(1e9) * step / window_height_;
  double height = step / 5;
  if (climb > 0) height = std::min(height, climb);
  if (band.ceiling_agl_m) height = std::min(height, (*band.ceiling_agl_m - band.clearance_m) / 4);
  steps_m_.z() = steps.height_m > 0 ? steps.height_m : std::max(height, 1e-3 * step);
  double lowest = std::min(start_.z(), goal_.z());
  double highest = std::max(start_.z(), goal_.z());
  for (const double ground : ground_) {
    if (std::isnan(ground)) continue;
    lowest = std::min(lowest, ground + band.clearance_m);
    highest = std::max(highest, ground + band.ceiling_agl_m.value_or(band.clearance_m + 2 * steps_m_.z()));
  }
  if (band.ceiling_amsl_m)
    highest = band.ceiling_agl_m ? std::min(highest, *band.ceiling_amsl_m) : *band.ceiling_amsl_m;
  if (!(steps.height_m > 0)) {
    const double room = static_cast<double>(kMostNodes) / (planes_ * columns_) - 2;
    steps_m_.z() = std::max(steps_m_.z(), (highest - lowest) / std::max(room, 1.0));
  }
  const double reach = window_height_ * planes_;
  const double down = std::max(-reach, (lowest - start_.z()) / steps_m_.z());
  const double up = std::min(reach, (highest - start_.z()) / steps_m_.z());
  if (is_too_large(columns_, up - down)) return;
  first_level_ = std::min(0, whole_up(down));
  levels_ = std::max(0, whole_down(up)) - first_level_ + 1;
}

void LatticeFrame::note_moves(const LatticeSteps& steps) {
  for (int side = -steps.window_side; side <= steps.window_side; ++side) {
    for (int height = -steps.window_height; height <= steps.window_height; ++height) {
      const Vec3 leg = steps_m_.x() * ahead_ + side * steps_m_.y() * aside_ + Vec3(0, 0, height * steps_m_.z());
      shifts_.push_back({side, height, leg});
      offsets_.push_back(static_cast<std::int32_t>(plane_size()) + side * levels_ + height);
    }
  }
}

LatticeFrame::Place LatticeFrame::place(Node node) const {
  const Node column = node / static_cast<Node>(levels_);
  return {.plane = static_cast<int>(column / static_cast<Node>(columns_)),
          .side = static_cast<int>(column % static_cast<Node>(columns_)),
          .height = static_cast<int>(node % static_cast<Node>(levels_))};
}

bool LatticeFrame::stays(const Place& at, unsigned move) const {
  const int side = at.side + shifts_[move].side;
  const int height = at.height + shifts_[move].height;
  return at.plane + 1 < planes_ && side >= 0 && side < columns_ && height >= 0 && height < levels_;
}

std::optional<unsigned> LatticeFrame::move(int side, int height) const {
  if (std::abs(side) > window_side_ || std::abs(height) > window_height_) return std::nullopt;
  return static_cast<unsigned>((side + window_side_) * (2 * window_height_ + 1) + height + window_height_);
}

Vec3 LatticeFrame::position(const Place& at) const {
  return start_ + at.plane * steps_m_.x() * ahead_ + (at.side + first_column_) * steps_m_.y() * aside_ +
         Vec3(0, 0, (at.height + first_level_) * steps_m_.z());
}

bool LatticeFrame::goal_in_window(const Vec3& from) const {
  const Vec3 rest = along(goal_ - from).cwiseAbs();
  return rest.y() <= (window_side_ + kHair) * steps_m_.y() && rest.z() <= (window_height_ + kHair) * steps_m_.z();
}

std::string LatticeFrame::plane_name(int plane) const {
  const Vec3 at = start_ + plane * steps_m_.x() * ahead_;
  if (main_ == MainDirection::line) return fmt::format("{:.0f} m along the straight line", plane * steps_m_.x());
  return main_ == MainDirection::x ? fmt::format("x {:.0f} m", at.x()) : fmt::format("y {:.0f} m", at.y());
}

}  // namespace alate
