#include "space/navigation_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr double kHair = 1e-9;

double length_for(double error, double rate) {
  if (rate <= 0) return error < 0 ? -1 : std::numeric_limits<double>::infinity();
  return error / rate;
}

}  // namespace

double ReducedLeg::reach_m(double error) const {
  const double exact = std::min(length_for(fresh_most, fresh_rate), length_for(carried_most - error, carried_rate));
  return exact + kHair * std::abs(exact);
}

ReducedLeg reduced_leg(const Navigation& navigation, PointKind from, PointKind to) {
  Navigation::Limits most = to == PointKind::vertical ? navigation.at_vertical : navigation.at_horizontal;
  if (to == PointKind::end) most.vertical = most.horizontal = std::nextafter(navigation.theta, -1.0);
  const bool fresh_is_vertical = from == PointKind::vertical;
  ReducedLeg leg{.fresh_rate = navigation.drift_vertical,
                 .carried_rate = navigation.drift_horizontal,
                 .fresh_most = most.vertical,
                 .carried_most = most.horizontal,
                 .carries_on = from == to};
  if (!fresh_is_vertical) {
    std::swap(leg.fresh_rate, leg.carried_rate);
    std::swap(leg.fresh_most, leg.carried_most);
  }
  return leg;
}

}  // namespace alate
