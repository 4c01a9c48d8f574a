// Scales and axes of diagrams.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "out/report/svg.hpp"

namespace alate {

/// A range of numbers drawn onto a range of user units.
struct Scale {
  double from = 0;
  double to = 1;
  double pixel_from = 0;
  double pixel_to = 1;

  double operator()(double value) const { return pixel_from + (value - from) / (to - from) * (pixel_to - pixel_from); }
};

/// 1, 2 or 5 times a power of ten, at least `least` (> 0).
double round_step(double least);

/// Round numbers within [from, to], `about` of them or fewer.
std::vector<double> ticks(double from, double to, int about);

/// The tick as short as it can be told from its neighbours: "12", "12.5".
std::string tick_label(double value, double step);

/// Where a diagram lies inside its drawing.
struct PlotArea {
  Vec2 corner;  ///< Upper left.
  Vec2 size;
};

struct Axes {
  PlotArea area;
  Scale x;
  Scale y;
  std::string x_title;
  std::string y_title;
};

/// Grid lines, tick labels and titles, by the classes `grid`, `tick` and `axis`.
void draw_axes(Svg& svg, const Axes& axes);

}  // namespace alate
