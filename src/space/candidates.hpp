// What can be done next from one state: a caller-owned structure of arrays, filled again at every expansion.
#pragma once

#include <cstddef>
#include <limits>

#include "space/simd.hpp"

namespace alate {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Index k belongs to action k in every array. Nothing is allocated once the size has been reached.
struct Candidates {
  AlignedDoubles ux, uy, uz;  ///< Unit direction of the leg.
  AlignedDoubles x, y, z;     ///< Where the leg ends, frame metres.
  AlignedDoubles to_goal;     ///< Straight distance left, metres.
  AlignedDoubles cost;        ///< Of the leg; infinite: not in K by what costs little to test (climb, descent, turn).
  AlignedDoubles guide;       ///< Estimated cost from there to the goal; infinite where no way is seen.

  std::size_t size() const { return x.size(); }

  void resize(std::size_t count) {
    for (AlignedDoubles* array : {&ux, &uy, &uz, &x, &y, &z, &to_goal, &cost, &guide}) array->resize(count);
  }
};

}  // namespace alate
