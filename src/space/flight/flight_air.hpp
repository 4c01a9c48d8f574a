// Everything that walks and prices flights through one world.
#pragma once

#include <utility>

#include "space/flight/flight_cost.hpp"
#include "space/objective.hpp"

namespace alate {

/// One world, as flights through it are walked and judged. Its parts refer to each other, so it stays where it is.
struct FlightAir {
  explicit FlightAir(World of) : world(std::move(of)) {}
  FlightAir(const FlightAir&) = delete;
  FlightAir& operator=(const FlightAir&) = delete;

  World world;
  BandWalk band{world};
  FlightCost cost{band};
  Objective objective{world};
};

}  // namespace alate
