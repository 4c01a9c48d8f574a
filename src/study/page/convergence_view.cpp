#include "study/page/convergence_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "out/report/axis.hpp"
#include "out/report/svg.hpp"

namespace alate {

namespace {

constexpr double kWidth = 420;
constexpr double kHeight = 290;
const PlotArea kArea{.corner = {62, 34}, .size = {340, 194}};
constexpr double kPointsPerDecade = 16;

double percent_above(double cost, double bound) { return 100 * (cost - bound) / bound; }

/// 1, 2, ... and then ever wider apart; the last is `count`.
std::vector<std::size_t> spaced_iterations(std::size_t count) {
  std::vector<std::size_t> iterations;
  for (int i = 0; iterations.empty() || iterations.back() < count; ++i) {
    const auto next = static_cast<std::size_t>(std::lround(std::pow(10, i / kPointsPerDecade)));
    if (iterations.empty() || next > iterations.back()) iterations.push_back(std::min(next, count));
  }
  return iterations;
}

/// Nothing unless every run has a route by `iteration`. A run that ended early keeps its last.
std::optional<Convergence::Point> point_at(const Trial& trial, const std::optional<double>& given, std::size_t after,
                                           std::size_t iteration) {
  std::vector<double> best;
  std::vector<double> mean;
  for (const StudyRun& run : trial.runs) {
    const auto& history = run.plan.history;
    if (history.empty()) return std::nullopt;
    const IterationStats& now = history[std::min(iteration, history.size()) - 1];
    if (!now.best_so_far) return std::nullopt;
    const double bound = given.value_or(run.plan.lower_bound);
    best.push_back(percent_above(*now.best_so_far, bound));
    for (std::size_t i = after; i < std::min(iteration, history.size()); ++i)
      if (history[i].mean) mean.push_back(percent_above(*history[i].mean, bound));
  }
  const auto of_best = summarize(best);
  const auto of_mean = summarize(mean);
  return Convergence::Point{.at = static_cast<double>(iteration),
                            .best = of_best->mean,
                            .least = of_best->least,
                            .greatest = of_best->greatest,
                            .mean = of_mean ? std::optional(of_mean->mean) : std::nullopt};
}

/// Logarithmic axes, drawn as linear ones over powers of ten.
struct LogAxes {
  Scale x;
  Scale y;

  Vec2 at(double place, double percent) const { return {x(std::log10(place)), y(std::log10(percent))}; }
};

/// 1, 2, 5, 10, ... within the scale.
std::vector<double> log_ticks(const Scale& scale) {
  std::vector<double> values;
  for (int power = static_cast<int>(std::floor(scale.from)); power <= scale.to; ++power)
    for (const double factor : {1.0, 2.0, 5.0})
      if (const double value = factor * std::pow(10, power);
          std::log10(value) >= scale.from - 1e-9 && std::log10(value) <= scale.to + 1e-9)
        values.push_back(value);
  return values;
}

void draw_grid(Svg& svg, const LogAxes& axes, const ConvergenceAxes& titles) {
  const Vec2 end = kArea.corner + kArea.size;
  for (const double value : log_ticks(axes.x)) {
    const double x = axes.x(std::log10(value));
    svg.line({x, kArea.corner.y()}, {x, end.y()}, "grid");
    svg.text({x, end.y() + 20}, fmt::format("{:g}", value), "tick", Anchor::middle);
  }
  for (const double value : log_ticks(axes.y)) {
    const double y = axes.y(std::log10(value));
    svg.line({kArea.corner.x(), y}, {end.x(), y}, "grid");
    svg.text({kArea.corner.x() - 8, y + 5}, fmt::format("{:g}", value), "tick", Anchor::end);
  }
  svg.text({end.x(), end.y() + 44}, titles.x_title, "axis", Anchor::end);
  svg.text({4, kArea.corner.y() - 14}, titles.y_title, "axis");
}

/// Broken where no ant arrived.
void draw_means(Svg& svg, const LogAxes& axes, const Convergence& line) {
  std::vector<Vec2> run;
  const auto finish = [&] {
    if (run.size() > 1) svg.polyline(run, "mean " + line.css_class);
    run.clear();
  };
  for (const Convergence::Point& point : line.points) {
    if (point.mean)
      run.push_back(axes.at(point.at, *point.mean));
    else
      finish();
  }
  finish();
}

void draw_best(Svg& svg, const LogAxes& axes, const Convergence& line) {
  std::vector<Vec2> best;
  for (const Convergence::Point& point : line.points) best.push_back(axes.at(point.at, point.best));
  svg.polyline(best, "best " + line.css_class);
}

void draw_band(Svg& svg, const LogAxes& axes, const Convergence& line) {
  std::vector<Vec2> outline;
  for (const auto& point : line.points) outline.push_back(axes.at(point.at, point.least));
  for (const auto& point : std::views::reverse(line.points)) outline.push_back(axes.at(point.at, point.greatest));
  svg.polygon(outline, "seeds " + line.css_class);
}

}  // namespace

Convergence convergence(const Trial& trial, const std::string& css_class, std::optional<double> bound) {
  std::size_t iterations = 0;
  for (const StudyRun& run : trial.runs) iterations = std::max(iterations, run.plan.history.size());
  Convergence line{.css_class = css_class, .points = {}};
  if (iterations == 0) return line;
  std::size_t after = 0;
  for (const std::size_t iteration : spaced_iterations(iterations)) {
    if (const auto point = point_at(trial, bound, after, iteration)) line.points.push_back(*point);
    after = iteration;
  }
  return line;
}

PercentRange percent_range(const std::vector<std::vector<Convergence>>& diagrams) {
  constexpr double kLeast = 0.01;  // A cost at the bound has no logarithm.
  PercentRange range{.from = 5, .to = 20};
  for (const auto& lines : diagrams) {
    for (const Convergence& line : lines) {
      for (const Convergence::Point& point : line.points) {
        range.from = std::min(range.from, std::max(kLeast, point.least / 1.1));
        range.to = std::max(range.to, 1.1 * point.greatest);
      }
    }
  }
  return range;
}

std::string convergence_svg(const std::vector<Convergence>& lines, const PercentRange& range, const std::string& title,
                            const ConvergenceAxes& titles) {
  double last = 2 * titles.from;
  for (const Convergence& line : lines)
    if (!line.points.empty()) last = std::max(last, line.points.back().at);
  Svg svg(kWidth, kHeight, title);
  const Vec2 end = kArea.corner + kArea.size;
  const LogAxes axes{.x = {std::log10(titles.from), std::log10(last), kArea.corner.x(), end.x()},
                     .y = {std::log10(range.from), std::log10(range.to), end.y(), kArea.corner.y()}};
  draw_grid(svg, axes, titles);
  svg.begin_clip(kArea.corner, kArea.size);
  for (const Convergence& line : lines) draw_band(svg, axes, line);
  for (const Convergence& line : lines) draw_means(svg, axes, line);
  for (const Convergence& line : lines) draw_best(svg, axes, line);
  svg.end_clip();
  return svg.str();
}

}  // namespace alate
