// How planners get better, iteration by iteration or with time, over their seeds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/experiment.hpp"

namespace alate {

/// The runs of one method on one case, as a line with its band. Costs are percent above the lower bound.
struct Convergence {
  struct Point {
    double at = 0;     ///< Iteration, from 1, or seconds.
    double best = 0;   ///< Best so far, mean over the seeds.
    double least = 0;  ///< Over the seeds.
    double greatest = 0;
    std::optional<double> mean;  ///< Of the ants that arrived since the last point, mean over iterations and seeds.
  };
  std::string css_class;
  std::vector<Point> points;
};

/// Points at iterations evenly spaced by their logarithm, from where every seed has a route; none for planners without
/// history. `bound`: what costs of the history cannot be below; none: the plan's lower bound.
Convergence convergence(const Trial& trial, const std::string& css_class, std::optional<double> bound = {});

/// Lowest and highest cost that diagrams show, percent above the bound.
struct PercentRange {
  double from = 1;
  double to = 100;
};

/// Holds the best costs and the bands of all lines.
PercentRange percent_range(const std::vector<std::vector<Convergence>>& diagrams);

/// What is told along the axes.
struct ConvergenceAxes {
  double from = 1;  ///< Where the lower axis begins.
  std::string x_title = "iteration";
  std::string y_title = "% above the bound";
};

/// A small diagram with logarithmic axes; what lies outside the range is cut off.
std::string convergence_svg(const std::vector<Convergence>& lines, const PercentRange& range, const std::string& title,
                            const ConvergenceAxes& titles = {});

}  // namespace alate
