// The world as planners query it: built once, never changed.
#pragma once

#include <memory>
#include <optional>

#include "alate/core/geometry.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Immutable and cheap to copy. Any thread may query it. No query allocates.
class World {
 public:
  explicit World(Site site);

  const Site& site() const;

  /// Ground height; nothing outside the ground, NaN where it is unknown. Zero everywhere without any ground.
  std::optional<double> height(const Vec2& xy) const;

  /// Lowest height of the leg above ground, exact along bilinear ground (for hills: never above the truth, and
  /// within 0.05 m of it). -infinity where the leg leaves the ground or crosses unknown ground; +infinity
  /// without any ground.
  double clearance(const Segment& leg) const;

  /// May the leg be flown: inside the ground, at least the band's clearance above it, under both ceilings, and
  /// outside every core? Decides as `clearance` does, and faster. Climb and turn limits are the vehicle's.
  bool is_free(const Segment& leg) const;

  /// Integral along the leg of sum level * max(0, 1 - d/r), metres; closed form for spheres and cylinders.
  double exposure(const Segment& leg) const;

  /// Does the leg come closer to a threat than its core?
  bool enters_core(const Segment& leg) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace alate
