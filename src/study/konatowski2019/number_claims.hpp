// The nine numbers that the paper prints: initial cost, best cost and gain under three weight pairs.
#pragma once

#include "study/konatowski2019/study.hpp"

namespace alate::konatowski2019 {

/// Beside the cost of the base route, the cheapest without regard to threats.
Claim initial_cost(const Study& study, std::size_t row);

/// Beside the mean of the paper's own method; impossible below the bound that holds for any layout.
Claim best_cost(const Study& study, std::size_t row);

/// From the base route to the mean of the paper's own method.
Claim gain_over_base(const Study& study, std::size_t row);

/// Gains over the base route on one layout, one a row; nothing where no route was found.
using GainsByRow = std::array<std::optional<double>, kPublished.size()>;
GainsByRow gains_of_best_routes(const Study& study, std::size_t layout);
GainsByRow gains_of_literal(const Study& study, std::size_t layout);

/// From the first arrivals of the paper's own method to its best.
Claim gain_of_ants(const Study& study, std::size_t row);

}  // namespace alate::konatowski2019
