#include "study/intrusion.hpp"

#include <algorithm>
#include <limits>

namespace alate {

Intrusion deepest_intrusion(const Threat& sphere, const Route& route) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Intrusion deepest{.along_legs = -kInfinite, .at_nodes = -kInfinite};
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const Segment leg = route.segment(i);
    const Vec3 nearest = leg.at(closest_parameter(leg, sphere.center));
    deepest.along_legs = std::max(deepest.along_legs, sphere.radius_m - (nearest - sphere.center).norm());
    deepest.at_nodes = std::max(deepest.at_nodes, sphere.radius_m - (leg.b - sphere.center).norm());
  }
  return deepest;
}

}  // namespace alate
