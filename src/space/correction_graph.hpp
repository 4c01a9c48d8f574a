// Correction points as all planners on them share them: structure of arrays, a grid to find neighbours by, reduced
// legs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "alate/world/world.hpp"
#include "space/navigation_error.hpp"

namespace alate {

/// Ground, ceilings, cores of threats or climb limits: can a straight leg be closed?
bool has_obstacles(const Site& site);

/// Points with start and goal, indexed 0 to size() - 1: first those that reset the vertical error, then those that
/// reset the horizontal one, each sorted by cells of a grid; then the start, then the goal. Arcs are found on demand.
class CorrectionGraph {
 public:
  using Node = std::uint32_t;

  /// The site must have navigation. The world must outlive the graph.
  explicit CorrectionGraph(const World& world);
  /// Without any obstacle.
  CorrectionGraph(const Navigation& navigation, const Vec3& start, const Vec3& goal);

  /// Only the points inside the ellipsoid |start p| + |p goal| <= `length_m`. No route up to this length uses others.
  CorrectionGraph within(double length_m) const;

  /// Of a part: the index of each node in the graph that it was cut from.
  std::span<const Node> whole() const { return whole_; }

  /// Only the points whose corrections never fail.
  CorrectionGraph reliable() const;

  std::size_t size() const { return x_.size(); }
  Node point_count() const { return static_cast<Node>(x_.size() - 2); }
  Node start() const { return point_count(); }
  Node goal() const { return point_count() + 1; }

  Vec3 position(Node i) const { return {x_[i], y_[i], z_[i]}; }
  /// Vertical or horizontal; the start counts as vertical, the goal as end.
  PointKind kind(Node i) const { return i == goal() ? PointKind::end : kind_of_point(i); }
  /// Id as the user numbers it.
  int id(Node i) const { return id_[i]; }
  double success(Node i) const { return success_[i]; }
  CorrectionPoint point(Node i) const {
    return {.id = id_[i], .position = position(i), .kind = kind(i), .success = success_[i]};
  }
  /// May any correction fail?
  bool unreliable() const { return unreliable_; }

  double length(Node i, Node j) const { return std::sqrt(squared_length(i, j)); }
  double from_start(Node i) const { return from_start_[i]; }  ///< length(start(), i).
  double to_goal(Node i) const { return to_goal_[i]; }        ///< length(i, goal()).

  /// Calls visit(j, length, error after j) for each point `j` that can be flown to from `i` with `error` there. Whether
  /// the leg is_free is left to the caller, as it may have cheaper reasons to pass it over.
  template <class Visit>
  void for_each_next(Node i, double error, Visit&& visit) const {
    for (const PointKind to : {PointKind::vertical, PointKind::horizontal}) {
      const ReducedLeg rule = leg(kind(i), to);
      const double reach = rule.reach_m(error);
      for_each_within(i, to, reach, [&](Node j, double d) {
        if (j != i && rule.keeps_limits(error, d)) visit(j, d, rule.after(error, d));
      });
    }
  }

  /// Calls visit(i, length, most error at i) for the start and each point `i` from which `j` can be flown to so that at
  /// most `most` error is left there; see ReducedLeg::most_before. For the goal `most` means nothing.
  template <class Visit>
  void for_each_previous(Node j, double most, Visit&& visit) const {
    const auto try_leg = [&](const ReducedLeg& rule, Node i, double d) {
      if (const double before = rule.most_before(most, d); before >= 0) visit(i, d, before);
    };
    for (const PointKind from : {PointKind::vertical, PointKind::horizontal}) {
      const ReducedLeg rule = leg(from, kind(j));
      const double reach = rule.reach_back_m(most);
      for_each_within(j, from, reach, [&](Node i, double d) {
        if (i != j) try_leg(rule, i, d);
      });
    }
    try_leg(leg(PointKind::vertical, kind(j)), start(), from_start(j));
  }

  /// Is the straight leg flown free of ground, ceilings and cores, and within the climb limits? Always, at no cost,
  /// where the site has none of these.
  bool is_free(Node i, Node j) const { return world_ == nullptr || leg_is_free(i, j); }

  const Navigation& limits() const { return limits_; }
  const ReducedLeg& leg(PointKind from, PointKind to) const {
    return legs_[from == PointKind::horizontal ? 1 : 0][to == PointKind::vertical     ? 0
                                                        : to == PointKind::horizontal ? 1
                                                                                      : 2];
  }
  const ReducedLeg& leg(Node i, Node j) const { return leg(kind(i), kind(j)); }

  /// Calls visit(first, last) with ranges of indices that hold all points of `kind` (vertical or horizontal) within
  /// `radius_m` of `i`, seen from above, in ascending order; they also hold others.
  template <class Visit>
  void near(Node i, PointKind kind, double radius_m, Visit&& visit) const {
    const Grid& grid = grids_[kind == PointKind::horizontal ? 1 : 0];
    if (!(radius_m >= 0) || grid.columns == 0) return;
    const double x = x_[i] - grid.min.x();
    const double y = y_[i] - grid.min.y();
    const int last_row = grid.row(y + radius_m);
    for (int row = grid.row(y - radius_m); row <= last_row; ++row) {
      const double away = std::max({0.0, row * grid.cell_m - y, y - (row + 1) * grid.cell_m});
      const double chord = std::sqrt(std::max(0.0, radius_m * radius_m - away * away));
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns);
      const Node first = grid.first[at + static_cast<std::size_t>(grid.column(x - chord))];
      const Node last = grid.first[at + static_cast<std::size_t>(grid.column(x + chord)) + 1];
      if (first < last) visit(first, last);
    }
  }

 private:
  /// Calls visit(j, length) for each point of `kind` within `radius_m`. Those within are gathered first, without a
  /// branch: whether one is, no processor can guess.
  template <class Visit>
  void for_each_within(Node i, PointKind kind, double radius_m, Visit&& visit) const {
    constexpr Node kBlock = 64;
    std::array<Node, kBlock> node;       // NOLINT(cppcoreguidelines-pro-type-member-init): filled before use
    std::array<double, kBlock> squared;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    const double most = radius_m * radius_m;
    near(i, kind, radius_m, [&](Node first, Node last) {
      for (Node from = first; from < last; from += kBlock) {
        std::size_t count = 0;
        for (Node j = from; j < std::min(last, from + kBlock); ++j) {
          node[count] = j;
          squared[count] = squared_length(i, j);
          count += squared[count] <= most ? 1U : 0U;
        }
        for (std::size_t k = 0; k < count; ++k) visit(node[k], std::sqrt(squared[k]));
      }
    });
  }

  double squared_length(Node i, Node j) const {
    const double x = x_[j] - x_[i];
    const double y = y_[j] - y_[i];
    const double z = z_[j] - z_[i];
    return x * x + y * y + z * z;
  }

  /// Cells of one kind of points, row by row: the points of cell c are first[c] to first[c + 1] - 1.
  struct Grid {
    Vec2 min = Vec2::Zero();
    double cell_m = 1;
    double cells_per_m = 1;
    int columns = 0;
    int rows = 0;
    std::vector<Node> first;

    int column(double x) const { return std::clamp(whole(x), 0, columns - 1); }
    int row(double y) const { return std::clamp(whole(y), 0, rows - 1); }
    /// Towards 0, which is the first column or row on either side.
    int whole(double v) const { return static_cast<int>(std::clamp(v * cells_per_m, -1.0, 1e9)); }
  };

  CorrectionGraph(Navigation limits, const World* world) : limits_(std::move(limits)), world_(world) {}
  /// The points for which keep(i).
  template <class Keep>
  CorrectionGraph part(Keep&& keep) const {
    std::vector<CorrectionPoint> kept;
    std::vector<Node> index;
    for (Node i = 0; i < point_count(); ++i) {
      if (!keep(i)) continue;
      kept.push_back(point(i));
      index.push_back(i);
    }
    index.insert(index.end(), {start(), goal()});
    CorrectionGraph part(limits_, world_);
    part.fill(kept, position(start()), position(goal()));
    for (Node& i : part.whole_) i = index[i];
    return part;
  }
  PointKind kind_of_point(Node i) const {
    return i < vertical_count_ || i == start() ? PointKind::vertical : PointKind::horizontal;
  }
  void fill(std::span<const CorrectionPoint> points, const Vec3& start, const Vec3& goal);
  void add(const CorrectionPoint& point, std::size_t index);
  void add_kind(std::span<const CorrectionPoint> points, PointKind kind);
  bool leg_is_free(Node i, Node j) const;

  Navigation limits_;             ///< Without its points.
  const World* world_ = nullptr;  ///< Null where nothing stands in the way.
  std::array<std::array<ReducedLeg, 3>, 2> legs_;
  std::array<Grid, 2> grids_;
  Node vertical_count_ = 0;
  bool unreliable_ = false;
  std::vector<double> x_, y_, z_;
  std::vector<double> success_;
  std::vector<double> from_start_, to_goal_;
  std::vector<int> id_;
  std::vector<Node> whole_;  ///< Before a part is done: places in the list of its points, start and goal last.
};

}  // namespace alate
