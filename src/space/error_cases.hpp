// Navigation errors where corrections may fail: what can have happened, and how probable it is (Zhou et al. 2020,
// problem 3).
#pragma once

#include <span>
#include <vector>

#include "space/navigation_error.hpp"

namespace alate {

/// One possible pair of errors and its probability.
struct ErrorCase {
  NavigationError error;
  double probability = 1;
};

/// A leg and what stands at its end.
struct CorrectionLeg {
  double length_m = 0;
  PointKind kind = PointKind::vertical;  ///< Or horizontal, or end.
  double success = 1;
};

/// Flies `leg` in every case and appends to `after` what is still within the limits, sorted by errors, equal errors
/// merged. Cases that break a limit are gone: their probability is lost. As many as 2^n histories end in few cases,
/// since a correction that works, and a residual, forget what was before.
void fly_cases(const Navigation& navigation, std::span<const ErrorCase> before, const CorrectionLeg& leg,
               std::vector<ErrorCase>& after);

/// Sum of the probabilities.
double total_probability(std::span<const ErrorCase> cases);

/// Exact probability that a flight of these legs breaks no limit, each correction failing or not independently of all
/// others.
double success_probability(const Navigation& navigation, std::span<const CorrectionLeg> legs);

/// Exact probability that a route of straight legs through `points` breaks no limit, each correction failing or not
/// independently of all others.
double success_probability(const Navigation& navigation, const Vec3& start, const Vec3& goal,
                           std::span<const CorrectionPoint> points);

}  // namespace alate
