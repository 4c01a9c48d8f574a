// The chance that no limit of the navigation errors is broken on a route.
#pragma once

#include <optional>
#include <span>

#include "check/corrections.hpp"

namespace alate {

/// Exact when points fail independently of each other: carries every pair of errors that is still alive with its chance
/// (Zhou et al. 2020, problem 3; min(error, residual) is what a failure leaves). 1 exactly if nothing can go wrong, 0
/// exactly if nothing can go right. Nothing where that takes more than 2e7 pairs, which only limits far from any
/// scenario of use need.
std::optional<double> success_chance(const Navigation& navigation, std::span<const Visit> visits);

}  // namespace alate
