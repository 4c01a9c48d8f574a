// The angle of a vector in the plane, for loops that are to vectorise.
#pragma once

#include <array>
#include <cmath>

#include "alate/core/geometry.hpp"

namespace alate {

/// atan(z) for |z| <= tan(pi / 8), to 3.4e-17 of its value before rounding: z + z^3 Q(z^2), minimax in z^2 (Remez).
[[gnu::always_inline]] inline double small_arctangent(double z) {
  constexpr std::array kQ{-0x1.5555555555204p-2, 0x1.9999999937e57p-3, -0x1.2492490174693p-3, 0x1.c71c64cc89ad5p-4,
                          -0x1.745bafba62966p-4, 0x1.3afb4b5390b3cp-4, -0x1.0ffe4020c7c87p-4, 0x1.d21493b9e8eacp-5,
                          -0x1.6470e8b0040cbp-5, 0x1.5adc5097b6c0dp-6};
  const double w = z * z;
  const double w2 = w * w;
  const double w4 = w2 * w2;
  // Estrin's scheme: short chains, for one vector at a time waits on every link of a long one.
  const double low = (kQ[0] + kQ[1] * w) + (kQ[2] + kQ[3] * w) * w2;
  const double middle = (kQ[4] + kQ[5] * w) + (kQ[6] + kQ[7] * w) * w2;
  const double high = kQ[8] + kQ[9] * w;
  return z + z * (w * (low + (middle + high * w4) * w4));
}

/// atan2(y, x) in [-pi, pi] to 5e-16 rad, without branches. 0 for no vector; the sign of a zero does not count.
[[gnu::always_inline]] inline double arctangent(double y, double x) {
  constexpr double kTanEighth = 0.41421356237309503;
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const double least = ax < ay ? ax : ay;
  const double most = ax < ay ? ay : ax;
  // tan(a - pi / 4) = (tan a - 1) / (tan a + 1)
  const bool beyond = least > kTanEighth * most;
  const double numerator = beyond ? least - most : least;
  const double sum = beyond ? least + most : most;
  const double denominator = sum > 0 ? sum : 1.0;
  const double eighth = (beyond ? kPi / 4 : 0.0) + small_arctangent(numerator / denominator);
  const double quarter = ax < ay ? kPi / 2 - eighth : eighth;
  const double half = x < 0 ? kPi - quarter : quarter;
  return y < 0 ? -half : half;
}

}  // namespace alate
