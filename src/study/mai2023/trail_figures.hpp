// What the printed rules do to ants and pheromone, told from the histories of runs.
#pragma once

#include <optional>

#include "study/mai2023/figures.hpp"

namespace alate::mai2023 {

/// Mean F of the ants over iterations `from` to `to`, counted from 1, and over the runs.
std::optional<double> ants_mean(const Trial& trial, std::size_t from, std::size_t to);

/// Eq. (15): q0 of iteration n, counted from 0, of N.
double scheduled_q0(double initial, std::size_t n, std::size_t count);

/// Where trails of the updated path tend to, Delta tau / rho by eqs. (16), (17), over all iterations of all runs.
struct FixedPoints {
  double least = 0;
  double greatest = 0;
};
std::optional<FixedPoints> fixed_points(const Trial& trial);

/// By how many percent the deposits of the last tenth of the iterations would differ had lambda not decayed: mean size.
std::optional<double> effect_of_decay_percent(const Trial& trial);

/// Share of all ants that walked into a dead end, percent.
double dead_ends_percent(const Trial& trial);

}  // namespace alate::mai2023
