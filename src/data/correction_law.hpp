// Synthetic correction points drawn by the law of the two contest sets (Zhou et al. 2020, problem F of 2019).
#pragma once

#include <cstdint>

#include "alate/data/site.hpp"

namespace alate {

/// Density and limits of the contest's first or second set of points.
enum class CorrectionLaw { set1, set2 };

/// Correction points between two ends; with a Scenario around it, a Site.
struct CorrectionField {
  Navigation navigation;
  Vec3 start = Vec3::Zero();
  Vec3 goal = Vec3::Zero();
};

/// `points` correction points with ids 1 to `points`, uniform in W x W x 10 km, W from the law's density (611 or 325
/// points in 100 x 100 km); start (0, W/2, 5 km) with id 0, goal (W, 0.6 W, 5 km) with id points + 1. Exactly half of
/// them (to one) reset the vertical error, and a quarter of either kind fails with probability 0.2. Coordinates are
/// whole centimetres, so that they survive a file with two decimals. The same law, number and seed give the same bits.
CorrectionField draw_corrections(CorrectionLaw law, int points, std::uint64_t seed);

}  // namespace alate
