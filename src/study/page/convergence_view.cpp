#include "study/page/convergence_view.hpp"

#include <algorithm>

#include "out/report/axis.hpp"
#include "out/report/svg.hpp"

namespace alate {

namespace {

constexpr double kWidth = 420;
constexpr double kHeight = 300;
const PlotArea kArea{.corner = {62, 34}, .size = {340, 204}};

double percent_above(double cost, double bound) { return 100 * (cost - bound) / bound; }

/// Nothing unless every run has a best cost at this iteration. A run that ended early keeps its last.
std::optional<Convergence::Point> point_at(const Trial& trial, std::size_t i) {
  std::vector<double> best;
  std::vector<double> mean;
  for (const StudyRun& run : trial.runs) {
    const auto& history = run.plan.history;
    if (history.empty()) return std::nullopt;
    const IterationStats& now = history[std::min(i, history.size() - 1)];
    if (!now.best_so_far) return std::nullopt;
    best.push_back(percent_above(*now.best_so_far, run.plan.lower_bound));
    if (now.mean && i < history.size()) mean.push_back(percent_above(*now.mean, run.plan.lower_bound));
  }
  const auto of_best = summarize(best);
  const auto of_mean = summarize(mean);
  return Convergence::Point{.iteration = i + 1,
                            .best = of_best->mean,
                            .least = of_best->least,
                            .greatest = of_best->greatest,
                            .mean = of_mean ? std::optional(of_mean->mean) : std::nullopt};
}

void draw_line(Svg& svg, const Axes& axes, const Convergence& line) {
  std::vector<Vec2> best;
  std::vector<Vec2> mean;
  for (const Convergence::Point& point : line.points) {
    const double x = axes.x(static_cast<double>(point.iteration));
    best.emplace_back(x, axes.y(point.best));
    if (point.mean) mean.emplace_back(x, axes.y(*point.mean));
  }
  svg.polyline(mean, "mean " + line.css_class);
  svg.polyline(best, "best " + line.css_class);
}

void draw_band(Svg& svg, const Axes& axes, const Convergence& line) {
  std::vector<Vec2> outline;
  for (const auto& point : line.points)
    outline.emplace_back(axes.x(static_cast<double>(point.iteration)), axes.y(point.least));
  for (auto point = line.points.rbegin(); point != line.points.rend(); ++point)
    outline.emplace_back(axes.x(static_cast<double>(point->iteration)), axes.y(point->greatest));
  svg.polygon(outline, "seeds " + line.css_class);
}

}  // namespace

Convergence convergence(const Trial& trial, const std::string& css_class, std::size_t count) {
  std::size_t iterations = 0;
  for (const StudyRun& run : trial.runs) iterations = std::max(iterations, run.plan.history.size());
  Convergence line{.css_class = css_class, .points = {}};
  const std::size_t stride = std::max<std::size_t>(1, iterations / count);
  for (std::size_t i = 0; i < iterations; ++i) {
    // The first iterations change most, and the last must not be missed.
    if (i % stride != 0 && i >= 10 && i + 1 != iterations) continue;
    if (const auto point = point_at(trial, i)) line.points.push_back(*point);
  }
  return line;
}

std::string convergence_svg(const std::vector<Convergence>& lines, double top_percent, const std::string& title) {
  std::size_t last = 2;
  for (const Convergence& line : lines)
    if (!line.points.empty()) last = std::max(last, line.points.back().iteration);
  Svg svg(kWidth, kHeight, title);
  const Vec2 end = kArea.corner + kArea.size;
  const Axes axes{.area = kArea,
                  .x = {1, static_cast<double>(last), kArea.corner.x(), end.x()},
                  .y = {0, top_percent, end.y(), kArea.corner.y()},
                  .x_title = "iteration",
                  .y_title = "% above the bound"};
  draw_axes(svg, axes);
  svg.begin_clip(kArea.corner, kArea.size);
  for (const Convergence& line : lines) draw_band(svg, axes, line);
  for (const Convergence& line : lines) draw_line(svg, axes, line);
  svg.end_clip();
  return svg.str();
}

}  // namespace alate
