// The front of length and corrections by boost::r_c_shortest_paths: exact, generic, nothing of ours in it.
#pragma once

#include <algorithm>
#include <array>
// Under the address sanitizer gcc takes an optional of the graph for uninitialised.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/r_c_shortest_paths.hpp>
#pragma GCC diagnostic pop
#include <vector>

#include "data/correction_law.hpp"
#include "support/front_value.hpp"

namespace alate::test {

class BoostFront {
 public:
  /// Legs that no error limit can ever allow are left out of the graph.
  explicit BoostFront(const CorrectionField& field) : limits_(&field.navigation) {
    const std::vector<CorrectionPoint>& points = field.navigation.points;
    const std::size_t n = points.size();
    std::vector<Vec3> at;
    for (const CorrectionPoint& point : points) {
      boost::add_vertex({static_cast<int>(at.size()), point.kind}, graph_);
      at.push_back(point.position);
    }
    boost::add_vertex({static_cast<int>(n), PointKind::start}, graph_);
    boost::add_vertex({static_cast<int>(n) + 1, PointKind::end}, graph_);
    at.push_back(field.start);
    at.push_back(field.goal);
    int edges = 0;
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; j < n + 2; ++j)
        if (const double length = (at[j] - at[i]).norm(); i != j && j != n && is_possible(length, graph_[j].kind))
          boost::add_edge(i, j, {edges++, length}, graph_);
  }

  /// By corrections.
  std::vector<FrontValue> solve() const {
    std::vector<std::vector<boost::graph_traits<Graph>::edge_descriptor>> ways;
    std::vector<Resources> arrived;
    const std::size_t n = boost::num_vertices(graph_);
    boost::r_c_shortest_paths(
        graph_, boost::get(&Vertex::index, graph_), boost::get(&Edge::index, graph_), n - 2, n - 1, ways, arrived,
        Resources{},
        [this](const Graph& g, Resources& next, const Resources& old, const auto& edge) {
          return extend(g[edge].length_m, g[boost::target(edge, g)].kind, old, next);
        },
        [](const Resources& a, const Resources& b) {
          return a.length_m <= b.length_m && a.corrections <= b.corrections && a.vertical <= b.vertical &&
                 a.horizontal <= b.horizontal;
        },
        std::allocator<boost::r_c_shortest_paths_label<Graph, Resources>>(),
        boost::default_r_c_shortest_paths_visitor());
    std::vector<FrontValue> values;
    for (const Resources& one : arrived) values.push_back({one.corrections, one.length_m});
    return front_of(std::move(values));
  }

 private:
  struct Vertex {
    int index = 0;
    PointKind kind = PointKind::vertical;
  };
  struct Edge {
    int index = 0;
    double length_m = 0;
  };
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, Vertex, Edge>;
  struct Resources {
    double length_m = 0;
    int corrections = 0;
    double vertical = 0;
    double horizontal = 0;
    bool operator==(const Resources&) const = default;
    auto operator<=>(const Resources&) const = default;
  };

  bool is_possible(double length_m, PointKind to) const {
    Resources ignored;
    return extend(length_m, to, {}, ignored);
  }

  /// Section 1 of the problem, word for word.
  bool extend(double length_m, PointKind to, const Resources& old, Resources& next) const {
    next = {old.length_m + length_m, old.corrections, old.vertical + limits_->drift_vertical * length_m,
            old.horizontal + limits_->drift_horizontal * length_m};
    if (to == PointKind::end) return next.vertical < limits_->theta && next.horizontal < limits_->theta;
    ++next.corrections;
    const Navigation::Limits& most = to == PointKind::vertical ? limits_->at_vertical : limits_->at_horizontal;
    if (next.vertical > most.vertical || next.horizontal > most.horizontal) return false;
    (to == PointKind::vertical ? next.vertical : next.horizontal) = 0;
    return true;
  }

  const Navigation* limits_;
  Graph graph_;
};

}  // namespace alate::test
