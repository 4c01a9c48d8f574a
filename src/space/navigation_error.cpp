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

double with_hair(double length_m) { return length_m + kHair * std::abs(length_m); }

}  // namespace

double ReducedLeg::reach_m(double error) const {
  return with_hair(std::min(length_for(fresh_most, fresh_rate), length_for(carried_most - error, carried_rate)));
}

double ReducedLeg::reach_back_m(double most_after) const {
  return with_hair(std::min({length_for(fresh_most, fresh_rate), length_for(carried_most + kErrorSlack, carried_rate),
                             length_for(most_after + kErrorSlack, carries_on ? carried_rate : fresh_rate)}));
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
