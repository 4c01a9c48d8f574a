// The altitude profile where a threat sees some altitudes more than others, for which no string pulled taut is best.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "space/flight/altitude_label.hpp"
#include "space/flight/taut_string.hpp"

namespace alate {

/// The altitudes of each gate that can be reached from `z_from` at the first and from which the last can be reached.
/// Floor and ceiling of the result keep the slope limits themselves, so any profile that keeps them still does when it
/// is brought between the two. Empty if there is no profile.
std::vector<Gate> tube_of(std::vector<Gate> gates, double z_from, const SlopeLimits& slopes);

struct ProfilePrices {
  double length = 1;  ///< Of a metre flown.
  double climb = 0;   ///< Of a metre of ascent.
  /// Of a stretch of track between two distances, flown level at each of these altitudes.
  std::function<void(double from_m, double to_m, std::span<const double> levels, std::span<double> exposures)> exposure;
};

/// The tube narrowed to a lane around its cheapest profile. Dynamic programming backward over stations every `step_m`;
/// at a station the cost to go is linear between altitudes evenly spread over the tube, and the altitude flown next is
/// the best of these, of the one flown so far and of the last two within the slope limits. Exact but for the spacing.
std::vector<Gate> sheltered_lane(const std::vector<Gate>& tube, double step_m, const SlopeLimits& slopes,
                                 const ProfilePrices& prices);

}  // namespace alate
