// How often an ant takes the best candidate instead of drawing, over the run.
//
// Source: Mai et al. 2023, eq. (15), verbatim. n counts iterations from 0 (ours); N0 = 0.7 N, compared in whole
// numbers. As printed it jumps from 0.3 to 0.5 of its first value at n = N0.
#pragma once

#include <cstdint>

namespace alate {

struct Q0Schedule {
  double initial = 0;  ///< q0 of the first iteration.
  bool is_constant = true;

  /// q0 of iteration `n` of `most` (0: no end in sight, and it stays as it begins).
  double operator()(std::uint64_t n, std::uint64_t most) const {
    if (is_constant || most == 0) return initial;
    const auto all = static_cast<double>(most);
    const auto now = static_cast<double>(n);
    if (10 * n < 7 * most) return (all - now) / all * initial;
    return (now - 0.7 * all) / all * initial + initial / 2;
  }
};

}  // namespace alate
