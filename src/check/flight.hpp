// What the rules judge: the site, the route, and every leg as straight pieces.
#pragma once

#include <optional>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"
#include "check/height_range.hpp"

namespace alate {

/// One leg, ready to be judged.
struct Leg {
  std::size_t index = 0;  ///< Of the state that ends it.
  std::vector<Segment> pieces;
  HeightRange above_ground;
};

/// Borrows site and route. A route of one state has one leg of no length, with index 0.
struct Flight {
  Flight(const Site& asked, const Route& flown);

  const Site& site;
  const Route& route;
  std::vector<Leg> legs;
};

/// Index of the first state whose numbers are not finite, or so large that no place on Earth has them.
std::optional<std::size_t> first_unusable_state(const Route& route);

}  // namespace alate
