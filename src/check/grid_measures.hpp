// Sizes of a route that only a grid gives.
#pragma once

#include "alate/core/route.hpp"
#include "alate/data/height_grid.hpp"

namespace alate {

/// L in cell sides, F and T of `route` (Yin et al. 2021). F is the standard deviation (n - 1) of the heights of the
/// cells that the route passes, one after the other; a cell beside it where it runs along a side counts as the free one
/// of both. T counts the changes of direction between legs.
GridMeasures grid_measures(const HeightGrid& grid, const Route& route);

}  // namespace alate
