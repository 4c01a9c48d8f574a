#include "study/mai2023/fitness.hpp"

#include <cmath>

namespace alate::mai2023 {

Fitness fitness_of(const std::vector<Vec3>& places) {
  constexpr double kKm = 1000;
  Fitness fitness;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Vec3 leg = places[i] - places[i - 1];
    fitness.length += leg.norm() / kKm;
    fitness.heights += places[i].z() / kKm;
    if (i > 1) fitness.turns += angle_between(places[i - 1] - places[i - 2], leg);
  }
  return fitness;
}

std::vector<Vec3> cut_by_planes(const Route& route, double step_m) {
  if (route.states.empty()) return {};
  std::vector<Vec3> places{route.states.front().position};
  const double start = places.front().x();
  const double end = route.states.back().position.x();
  const auto count = static_cast<std::size_t>(std::lround((end - start) / step_m));
  std::size_t i = 1;
  for (std::size_t plane = 1; plane < count; ++plane) {
    const double x = start + step_m * static_cast<double>(plane);
    while (i < route.states.size() && route.states[i].position.x() < x) {
      if (!(route.states[i].position.x() > route.states[i - 1].position.x())) return {};
      ++i;
    }
    const Segment leg = route.segment(i);
    places.push_back(leg.at((x - leg.a.x()) / (leg.b.x() - leg.a.x())));
  }
  places.push_back(route.states.back().position);
  return places;
}

}  // namespace alate::mai2023
