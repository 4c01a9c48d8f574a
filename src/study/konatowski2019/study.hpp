// All runs of the reproduction, and the figures that claims, defects and the page take from them.
#pragma once

#include <string_view>

#include "study/konatowski2019/paper.hpp"

namespace alate::konatowski2019 {

struct Study {
  Experiment main;  ///< Layouts A, C, F under three weight pairs: case 3 * layout + row.
  Experiment open;  ///< Without threats, fuel weighing 0.8: what the cheapest route of all costs.

  static std::size_t case_of(std::size_t layout, std::size_t row) { return layout * kPublished.size() + row; }
  const Trial& trial(std::size_t layout, std::size_t row, std::string_view method) const;
  /// The cheapest route without threats: the paper's "base route". Null if none was found.
  const Route* base_route() const;
};

/// Nothing run yet.
Study plan_study(const ReproduceOptions& options);

/// By how many percent `to` lies below `from`.
double gain_percent(double from, double to);

/// Mean gain of the best cost over the first that any ant of the same run arrived with, percent.
std::optional<double> gain_over_first(const Trial& trial);

/// How the means of two methods compare over all cells where both found routes.
struct Duel {
  std::size_t cells = 0;
  std::size_t won = 0;        ///< Cells where the first has the lower mean.
  double saving_percent = 0;  ///< By how much the first lies below the second, mean over the cells.
};
Duel duel(const Study& study, std::string_view first, std::string_view second);

}  // namespace alate::konatowski2019
