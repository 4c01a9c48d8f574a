#include "out/report/front_view.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "out/notes.hpp"
#include "out/report/axis.hpp"
#include "out/report/number_words.hpp"
#include "out/report/svg.hpp"

namespace alate {

namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 330;
const PlotArea kArea{{92, 46}, {880, 220}};
constexpr std::size_t kMostRows = 100;
constexpr std::size_t kMostLabels = 12;

using Front = std::vector<FrontPoint>;

/// Is this the route that the report shows?
bool is_chosen(const Result& result, const FrontPoint& point) {
  std::vector<int> ids;
  for (const RouteState& state : result.plan.route.states) {
    if (state.point_id) ids.push_back(*state.point_id);
  }
  return !point.points.empty() && std::ranges::search(ids, point.points).size() == point.points.size() &&
         result.metrics.corrections == point.points.size();
}

Axes axes_over(const Front& front) {
  const auto [fewest, most] = std::ranges::minmax(front, {}, &FrontPoint::corrections);
  // Wide enough that every grid line is a whole number.
  const double middle = std::floor((fewest.corrections + most.corrections) / 2.0);
  const double half = std::max(4.0, most.corrections - middle + 1);
  const auto [shortest, longest] = std::ranges::minmax(front, {}, &FrontPoint::length_m);
  const double room = std::max(0.15 * (longest.length_m - shortest.length_m), 0.002 * longest.length_m);
  return {.area = kArea,
          .x = {middle - half, middle + half, kArea.corner.x(), kArea.corner.x() + kArea.size.x()},
          .y = {(shortest.length_m - room) / 1000, (longest.length_m + room) / 1000, kArea.corner.y() + kArea.size.y(),
                kArea.corner.y()},
          .x_title = "Corrections",
          .y_title = "Length, km"};
}

std::string drawing(const Result& result) {
  const Front& front = result.plan.front;
  Svg svg(kWidth, kHeight, "Length of the best routes against their number of corrections");
  const Axes axes = axes_over(front);
  draw_axes(svg, axes);
  for (const FrontPoint& point : front) {
    const Vec2 at{axes.x(point.corrections), axes.y(point.length_m / 1000)};
    const std::string words = fmt::format("{} corrections, {}, chance of success {}", point.corrections,
                                          length_in_words(point.length_m), chance_in_words(point.probability));
    svg.circle(at, 7, is_chosen(result, point) ? "front chosen" : "front", words);
    if (front.size() <= kMostLabels)
      svg.text(at + Vec2{13, 5}, chance_in_words(point.probability), "label", Anchor::start);
  }
  return svg.str();
}

std::string row(const FrontPoint& point, bool chosen) {
  return fmt::format("<tr{}><td>{}</td><td>{}</td><td>{}</td><td class=\"ids\">{}{}</td></tr>\n",
                     chosen ? " class=\"chosen\"" : "", point.corrections, quantity(point.length_m, "m"),
                     chance_in_words(point.probability), fmt::join(point.points, " "),
                     chosen ? " <b>(this route)</b>" : "");
}

std::string table(const Result& result) {
  std::string rows;
  const Front& front = result.plan.front;
  const std::size_t shown = std::min(front.size(), kMostRows);
  for (std::size_t i = 0; i < shown; ++i) rows += row(front[i], is_chosen(result, front[i]));
  const std::string more =
      shown < front.size() ? fmt::format("<p>{} more stand in result.json.</p>\n", front.size() - shown) : "";
  return fmt::format(
      "<div class=\"scroll\"><table class=\"front\"><thead><tr><th scope=\"col\">Corrections</th>"
      "<th scope=\"col\">Length</th><th scope=\"col\">Chance of success</th><th "
      "scope=\"col\">Points</th></tr></thead>\n"
      "<tbody>\n{}</tbody></table></div>\n{}",
      rows, more);
}

}  // namespace

std::string front_figure(const Result& result) {
  if (result.plan.front.empty()) return {};
  return fmt::format("<figure>\n{}</figure>\n{}", drawing(result), table(result));
}

}  // namespace alate
