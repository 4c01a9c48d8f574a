// Flights of a fixed wing from correction point to correction point over real ground, one leg after the other.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "alate/core/run_context.hpp"
#include "plan/flight/flight_ends.hpp"

namespace alate {

/// A leg of arcs and straight pieces.
struct FlownLeg {
  Route route;  ///< With its start; ends at the very place that was asked for, or in the goal's ball.
  PlanarPose end;
  double length_m = 0;
  double cost = 0;
};

/// Flies to any place of one site by the interval search. What is known of a place (the climb field above all) is kept.
class CorrectionLegs {
 public:
  /// The site must outlive this; its navigation counts for nothing here.
  CorrectionLegs(const Site& site, RunContext& run);
  ~CorrectionLegs();
  CorrectionLegs(const CorrectionLegs&) = delete;
  CorrectionLegs& operator=(const CorrectionLegs&) = delete;

  /// To within `tolerance_m` of `place`; nothing if no flight is found, or `run` ends it. `name` numbers the place; the
  /// same start gives the same leg.
  std::optional<FlownLeg> fly(const FlightStart& start, int name, const Vec3& place, double tolerance_m);

 private:
  struct Target;

  const Site& site_;
  RunContext& run_;
  std::map<int, std::unique_ptr<Target>> targets_;
};

}  // namespace alate
