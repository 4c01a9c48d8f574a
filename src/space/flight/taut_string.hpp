// The shortest altitude profile between floor and ceiling.
#pragma once

#include <vector>

namespace alate {

/// Where the profile must pass: at `at_m` along the track not below `floor`, not above `ceiling`.
struct Gate {
  double at_m = 0;
  double floor = 0;
  double ceiling = 0;
};

struct ProfilePoint {
  double at_m = 0;
  double z = 0;
};

/// The string pulled taut through the gates, from z to z: its bends, both ends included. Gates by at_m, each open. Of
/// all profiles it has the least sum of any convex function of the slope, so at once the least length, the least ascent
/// and the least of greatest slopes: it keeps climb and descent limits wherever any profile does.
std::vector<ProfilePoint> taut_string(const std::vector<Gate>& gates, double z_from, double z_to);

/// Altitude at `at_m`, straight between points.
double altitude_at(const std::vector<ProfilePoint>& profile, double at_m);

}  // namespace alate
