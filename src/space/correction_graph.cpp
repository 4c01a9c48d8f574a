#include "space/correction_graph.hpp"

#include <numeric>

namespace alate {

namespace {

/// The limits alone.
Navigation without_points(const Navigation& navigation) {
  return {.drift_vertical = navigation.drift_vertical,
          .drift_horizontal = navigation.drift_horizontal,
          .at_vertical = navigation.at_vertical,
          .at_horizontal = navigation.at_horizontal,
          .theta = navigation.theta,
          .residual = navigation.residual,
          .turn_model = navigation.turn_model,
          .turn_radius_m = navigation.turn_radius_m,
          .start_id = navigation.start_id,
          .goal_id = navigation.goal_id};
}

}  // namespace

bool has_obstacles(const Site& site) {
  return site.has_ground() || site.band.ceiling_amsl_m || site.vehicle.climb_rad || site.vehicle.descent_rad ||
         std::ranges::any_of(site.threats, [](const Threat& threat) { return threat.core_m > 0; });
}

CorrectionGraph::CorrectionGraph(const World& world)
    : CorrectionGraph(without_points(*world.site().navigation), has_obstacles(world.site()) ? &world : nullptr) {
  fill(world.site().navigation->points, world.site().mission.start, world.site().mission.goal);
}

CorrectionGraph::CorrectionGraph(const Navigation& navigation, const Vec3& start, const Vec3& goal)
    : CorrectionGraph(without_points(navigation), nullptr) {
  fill(navigation.points, start, goal);
}

CorrectionGraph CorrectionGraph::within(double length_m) const {
  return part([&](Node i) { return from_start(i) + to_goal(i) <= length_m; });
}

CorrectionGraph CorrectionGraph::reliable() const {
  return part([&](Node i) { return success_[i] >= 1; });
}

void CorrectionGraph::fill(std::span<const CorrectionPoint> points, const Vec3& start, const Vec3& goal) {
  for (std::vector<double>* one : {&x_, &y_, &z_, &success_}) one->reserve(points.size() + 2);
  id_.reserve(points.size() + 2);
  whole_.reserve(points.size() + 2);
  for (const PointKind from : {PointKind::vertical, PointKind::horizontal})
    for (const PointKind to : {PointKind::vertical, PointKind::horizontal, PointKind::end})
      legs_[from == PointKind::horizontal ? 1 : 0][to == PointKind::vertical     ? 0
                                                   : to == PointKind::horizontal ? 1
                                                                                 : 2] = reduced_leg(limits_, from, to);
  add_kind(points, PointKind::vertical);
  vertical_count_ = static_cast<Node>(x_.size());
  add_kind(points, PointKind::horizontal);
  add({.id = limits_.start_id, .position = start}, points.size());
  add({.id = limits_.goal_id, .position = goal}, points.size() + 1);
  from_start_.resize(size());
  to_goal_.resize(size());
  for (Node i = 0; i < size(); ++i) {
    from_start_[i] = length(this->start(), i);
    to_goal_[i] = length(i, this->goal());
  }
}

void CorrectionGraph::add(const CorrectionPoint& point, std::size_t index) {
  x_.push_back(point.position.x());
  y_.push_back(point.position.y());
  z_.push_back(point.position.z());
  id_.push_back(point.id);
  success_.push_back(point.success);
  whole_.push_back(static_cast<Node>(index));
  unreliable_ = unreliable_ || point.success < 1;
}

/// A counting sort by cells of about four points each; within a cell the order of `points` stays.
void CorrectionGraph::add_kind(std::span<const CorrectionPoint> points, PointKind kind) {
  Grid& grid = grids_[kind == PointKind::horizontal ? 1 : 0];
  std::size_t count = 0;
  Vec2 max = Vec2::Zero();
  for (const CorrectionPoint& point : points) {
    if (point.kind != kind) continue;
    const Vec2 xy = point.position.head<2>();
    grid.min = count == 0 ? xy : Vec2(grid.min.cwiseMin(xy));
    max = count == 0 ? xy : Vec2(max.cwiseMax(xy));
    ++count;
  }
  if (count == 0) return;
  const Vec2 extent = max - grid.min;
  const auto n = static_cast<double>(count);
  grid.cell_m = std::max({2 * std::sqrt(extent.x() * extent.y() / n), extent.maxCoeff() / n, 1e-3});
  grid.cells_per_m = 1 / grid.cell_m;
  grid.columns = grid.whole(extent.x()) + 1;
  grid.rows = grid.whole(extent.y()) + 1;

  const auto cell_of = [&](const CorrectionPoint& point) {
    const Vec2 xy = point.position.head<2>() - grid.min;
    return static_cast<std::size_t>(grid.row(xy.y())) * static_cast<std::size_t>(grid.columns) +
           static_cast<std::size_t>(grid.column(xy.x()));
  };
  const std::size_t cells = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  grid.first.assign(cells + 1, 0);
  for (const CorrectionPoint& point : points)
    if (point.kind == kind) ++grid.first[cell_of(point) + 1];
  std::partial_sum(grid.first.begin(), grid.first.end(), grid.first.begin());
  std::vector<Node> place = grid.first;
  std::vector<Node> sorted(count);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].kind == kind) sorted[place[cell_of(points[k])]++] = static_cast<Node>(k);
  const Node offset = static_cast<Node>(x_.size());
  for (Node& first : grid.first) first += offset;
  for (const Node k : sorted) add(points[k], k);
}

bool CorrectionGraph::leg_is_free(Node i, Node j) const {
  const Segment leg{position(i), position(j)};
  const Vehicle& vehicle = world_->site().vehicle;
  const double angle = climb_angle(leg);
  if (vehicle.climb_rad && angle > *vehicle.climb_rad) return false;
  if (vehicle.descent_rad && -angle > *vehicle.descent_rad) return false;
  return world_->is_free(leg);
}

}  // namespace alate
