// How a colony gets better, iteration by iteration, over its seeds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/experiment.hpp"

namespace alate {

/// The runs of one method on one case, as a line with its band.
struct Convergence {
  struct Point {
    std::size_t iteration = 0;  ///< From 1.
    double best = 0;            ///< Best so far, mean over the seeds.
    double least = 0;           ///< Over the seeds.
    double greatest = 0;
    std::optional<double> mean;  ///< Mean of the iteration's ants, mean over the seeds where any arrived.
  };
  std::string css_class;
  std::vector<Point> points;
};

/// Costs as percent above the trial's lower bound, at about `count` iterations. Points begin where every seed has a
/// route; empty for planners without history.
Convergence convergence(const Trial& trial, const std::string& css_class, std::size_t count);

/// A small diagram; the height ends at `top_percent`, and what lies above is cut off.
std::string convergence_svg(const std::vector<Convergence>& lines, double top_percent, const std::string& title);

}  // namespace alate
