#include "ga/gene_rectangle.hpp"

#include <cassert>
#include <optional>

namespace alate {

GeneRectangle::GeneRectangle(const CorrectionGraph& graph, double width_m, std::size_t cells)
    : graph_(graph), start_(graph.position(graph.start()).head<2>()), width_m_(width_m), cells_(cells) {
  const Vec2 line = graph.position(graph.goal()).head<2>() - start_;
  length_m_ = line.norm();
  if (length_m_ > 0) direction_ = line / length_m_;
  for (Node i = 0; i < graph.point_count(); ++i) {
    const Coordinate place = at(i);
    if (!contains(place)) continue;
    cells_[cell_of(place)].push_back({place, i});
    ++points_;
  }
}

GeneRectangle::Coordinate GeneRectangle::at(Node point) const {
  const Vec2 from_start = graph_.position(point).head<2>() - start_;
  return {.along_m = from_start.dot(direction_),
          .left_m = direction_.x() * from_start.y() - direction_.y() * from_start.x()};
}

GeneRectangle::Coordinate GeneRectangle::draw(Stream& stream) const {
  const double along = stream.uniform() * length_m_;
  return {.along_m = along, .left_m = (stream.uniform() - 0.5) * width_m_};
}

GeneRectangle::Coordinate GeneRectangle::draw_in(std::size_t cell, Stream& stream) const {
  const double cell_m = length_m_ / static_cast<double>(cells_.size());
  const double along = (static_cast<double>(cell) + stream.uniform()) * cell_m;
  return {.along_m = along, .left_m = (stream.uniform() - 0.5) * width_m_};
}

bool GeneRectangle::contains(const Coordinate& place) const {
  return place.along_m >= 0 && place.along_m <= length_m_ && std::abs(place.left_m) <= width_m_ / 2;
}

std::size_t GeneRectangle::cell_of(const Coordinate& place) const {
  if (!(length_m_ > 0)) return 0;
  const double cell = place.along_m / length_m_ * static_cast<double>(cells_.size());
  return std::min(cells_.size() - 1, static_cast<std::size_t>(std::max(0.0, cell)));
}

GeneRectangle::Node GeneRectangle::nearest_unused(const Coordinate& place, const std::vector<Node>& used) const {
  std::optional<Node> best;
  double least = 0;
  const auto look_in = [&](const std::vector<Place>& cell) {
    for (const Place& one : cell) {
      const double along = one.at.along_m - place.along_m;
      const double left = one.at.left_m - place.left_m;
      const double distance = along * along + left * left;
      if ((best && distance >= least) || std::ranges::find(used, one.node) != used.end()) continue;
      best = one.node;
      least = distance;
    }
  };
  look_in(cells_[cell_of(place)]);
  if (!best) std::ranges::for_each(cells_, look_in);
  assert(best);
  return *best;
}

}  // namespace alate
