// The drawings of the reproduction page, as figures.
#pragma once

#include <string>

#include "study/zhou2020/claims.hpp"

namespace alate::zhou2020 {

/// The proven optimum, the genetic algorithm's best and a published route among the points of a set, on problem 1.
std::string routes_picture(const Study& study, std::size_t set, const std::vector<JudgedRow>& rows);

/// What the published genetic algorithm begins with: a few chromosomes of its first population over their rectangle.
std::string population_picture(const Study& study, std::size_t set);

/// Rates of crossover and mutation over fitness, as the formula has them.
std::string rates_picture(const Study& study);

/// How far the genetic algorithms come with the iterations.
std::string fitness_picture(const Study& study, std::size_t set);

}  // namespace alate::zhou2020
