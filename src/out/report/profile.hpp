// The route cut upright: heights along the way, with the ground below.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/out/result.hpp"

namespace alate {

struct ProfileSample {
  double along_m = 0;  ///< Distance flown over the ground.
  Vec3 position;
  std::optional<double> ground_m;  ///< Nothing where there is no ground or it is unknown.
};

/// Every point of the drawn line and evenly spaced ones between them, about `count` in all.
std::vector<ProfileSample> sample_profile(const Site& site, const Route& route, int count);

/// A stretch of the way inside a threat's radius.
struct ThreatSpan {
  std::string name;
  double from_m = 0;
  double to_m = 0;
};

std::vector<ThreatSpan> threat_spans(const Site& site, const std::vector<ProfileSample>& samples);

/// The sample of least height above ground; by the check's word where it judged it.
std::optional<ProfileSample> lowest_clearance(const Result& result, const std::vector<ProfileSample>& samples);

}  // namespace alate
