#include "space/flight/taut_string.hpp"

#include <algorithm>
#include <limits>

namespace alate {

namespace {

/// What can be seen straight ahead from a point: a funnel of slopes, and the gates that bound it.
struct Funnel {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::size_t at_least = 0;
  std::size_t at_most = 0;
};

}  // namespace

std::vector<ProfilePoint> taut_string(const std::vector<Gate>& gates, double z_from, double z_to) {
  std::vector<ProfilePoint> bends{{gates.front().at_m, z_from}};
  std::size_t apex = 0;
  while (apex + 1 < gates.size()) {
    const ProfilePoint at = bends.back();
    Funnel funnel{.at_least = gates.size(), .at_most = gates.size()};
    std::size_t bend = gates.size() - 1;
    double z = z_to;
    for (std::size_t k = apex + 1; k < gates.size(); ++k) {
      const bool last = k + 1 == gates.size();
      const double floor = last ? z_to : gates[k].floor;
      const double ceiling = last ? z_to : gates[k].ceiling;
      const double ahead = gates[k].at_m - at.at_m;
      if (ahead <= 0) continue;
      const double low = (floor - at.z) / ahead;
      const double high = (ceiling - at.z) / ahead;
      if (low > funnel.most) {  // the string bends at the lowest ceiling seen
        bend = funnel.at_most;
        z = gates[bend].ceiling;
        break;
      }
      if (high < funnel.least) {
        bend = funnel.at_least;
        z = gates[bend].floor;
        break;
      }
      if (low >= funnel.least) {
        funnel.least = low;
        funnel.at_least = k;
      }
      if (high <= funnel.most) {
        funnel.most = high;
        funnel.at_most = k;
      }
    }
    bends.push_back({gates[bend].at_m, z});
    apex = bend;
  }
  return bends;
}

double altitude_at(const std::vector<ProfilePoint>& profile, double at_m) {
  const auto after = std::ranges::upper_bound(profile, at_m, {}, &ProfilePoint::at_m);
  if (after == profile.begin()) return profile.front().z;
  if (after == profile.end()) return profile.back().z;
  const ProfilePoint& a = *(after - 1);
  const ProfilePoint& b = *after;
  return a.z + (at_m - a.at_m) / (b.at_m - a.at_m) * (b.z - a.z);
}

}  // namespace alate
