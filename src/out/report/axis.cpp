#include "out/report/axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

constexpr double kUnitsPerTickX = 110;
constexpr double kUnitsPerTickY = 45;

int tick_count(double length, double units_per_tick) { return std::max(2, static_cast<int>(length / units_per_tick)); }

}  // namespace

double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<double> ticks(double from, double to, int about) {
  const double step = round_step((to - from) / about);
  std::vector<double> values;
  for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
    values.push_back(k * step + 0.0);  // never -0
  return values;
}

std::string tick_label(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fmt::format("{:.{}f}", value, decimals);
}

void draw_axes(Svg& svg, const Axes& axes) {
  const auto& [corner, size] = axes.area;
  const Vec2 end = corner + size;
  const int across = tick_count(size.x(), kUnitsPerTickX);
  const int down = tick_count(size.y(), kUnitsPerTickY);
  for (const double value : ticks(axes.x.from, axes.x.to, across)) {
    const double x = axes.x(value);
    svg.line({x, corner.y()}, {x, end.y()}, "grid");
    svg.text({x, end.y() + 22}, tick_label(value, round_step((axes.x.to - axes.x.from) / across)), "tick",
             Anchor::middle);
  }
  for (const double value : ticks(axes.y.from, axes.y.to, down)) {
    const double y = axes.y(value);
    svg.line({corner.x(), y}, {end.x(), y}, "grid");
    svg.text({corner.x() - 8, y + 5}, tick_label(value, round_step((axes.y.to - axes.y.from) / down)), "tick",
             Anchor::end);
  }
  svg.text({end.x(), end.y() + 48}, axes.x_title, "axis", Anchor::end);
  svg.text({corner.x() - 60, corner.y() - 12}, axes.y_title, "axis");
}

}  // namespace alate
