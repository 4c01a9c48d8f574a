// The part of a leg between two heights.
#pragma once

#include <algorithm>
#include <optional>

#include "alate/core/geometry.hpp"

namespace alate {

struct Part {
  double t0 = 0;
  double t1 = 1;
};

/// Parameters between which a leg from height a.z to b.z is within [floor, top]; nothing if it never is.
inline std::optional<Part> part_between(const Segment& leg, double floor, double top) {
  const double from = leg.a.z();
  const double rise = leg.b.z() - from;
  if (rise == 0) return from >= floor && from <= top ? std::optional(Part{}) : std::nullopt;
  const double at_floor = (floor - from) / rise;
  const double at_top = (top - from) / rise;
  const Part part{std::max(0.0, std::min(at_floor, at_top)), std::min(1.0, std::max(at_floor, at_top))};
  return part.t0 <= part.t1 ? std::optional(part) : std::nullopt;
}

}  // namespace alate
