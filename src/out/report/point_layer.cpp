#include "out/report/point_layer.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "out/notes.hpp"
#include "out/report/number_words.hpp"

namespace alate {

namespace {

constexpr std::size_t kMostDrawn = 3000;
constexpr double kSize = 6;
constexpr double kUsedSize = 10;
constexpr std::size_t kMostIds = 60;

bool in_view(const MapFrame& map, const CorrectionPoint& point) { return map.area.contains(point.position.head<2>()); }

/// One in how many points is drawn.
std::size_t stride_of(const MapFrame& map, const Navigation& navigation) {
  const auto shown =
      std::ranges::count_if(navigation.points, [&](const CorrectionPoint& point) { return in_view(map, point); });
  return (static_cast<std::size_t>(shown) + kMostDrawn - 1) / kMostDrawn;
}

std::string words_of(const CorrectionPoint& point) {
  std::string text = fmt::format("{}: {}", point.id, point.kind == PointKind::vertical ? "vertical" : "horizontal");
  if (point.success < 1) text += fmt::format(", works with a chance of {}", chance_in_words(point.success));
  return text;
}

std::string class_of(const CorrectionPoint& point) {
  return fmt::format("point {}{}", point.kind == PointKind::vertical ? "vertical" : "horizontal",
                     point.success < 1 ? " unsure" : "");
}

std::vector<Vec2> shape_of(PointKind kind, const Vec2& at, double size) {
  if (kind == PointKind::vertical)
    return {at + Vec2{0, -size}, at + Vec2{size, 0.8 * size}, at + Vec2{-size, 0.8 * size}};
  return {at + Vec2{0, -size}, at + Vec2{size, 0}, at + Vec2{0, size}, at + Vec2{-size, 0}};
}

/// The same shape in the legend.
std::string mark(const CorrectionPoint& point) {
  std::string corners;
  for (const Vec2& p : shape_of(point.kind, {8, 8}, kSize)) corners += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  return fmt::format(R"(<svg class="mark" viewBox="0 0 16 16"><polygon class="{}" points="{}"/></svg>)",
                     class_of(point), corners);
}

std::string key(const std::string& marks, const char* text) { return fmt::format("<li>{}{}</li>\n", marks, text); }

}  // namespace

void draw_points(Svg& svg, const MapFrame& map, const Site& site) {
  if (!site.navigation) return;
  const std::size_t stride = stride_of(map, *site.navigation);
  std::size_t seen = 0;
  for (const CorrectionPoint& point : site.navigation->points) {
    if (in_view(map, point) && seen++ % stride == 0)
      svg.polygon(shape_of(point.kind, map(point.position), kSize), class_of(point), words_of(point));
  }
}

void draw_used_points(Svg& svg, const MapFrame& map, const Site& site, const Route& route) {
  if (!site.navigation) return;
  std::vector<int> ids;
  for (const RouteState& state : route.states) {
    if (state.point_id) ids.push_back(*state.point_id);
  }
  std::ranges::sort(ids);
  const auto used = [&](const CorrectionPoint& point) { return std::ranges::binary_search(ids, point.id); };
  for (const CorrectionPoint& point : site.navigation->points) {
    if (!used(point)) continue;
    const Vec2 at = map(point.position);
    svg.polygon(shape_of(point.kind, at, kUsedSize), class_of(point) + " used", words_of(point));
    if (ids.size() <= kMostIds) svg.text(at + Vec2{0, -14}, fmt::format("{}", point.id), "label", Anchor::middle);
  }
}

std::string points_key(const MapFrame& map, const Site& site) {
  if (!site.navigation) return {};
  std::string items = key(mark({.kind = PointKind::vertical}), "Corrects the vertical error") +
                      key(mark({.kind = PointKind::horizontal}), "Corrects the horizontal error");
  const auto unsure = [](const CorrectionPoint& point) { return point.success < 1; };
  if (std::ranges::any_of(site.navigation->points, unsure)) {
    items +=
        key(mark({.kind = PointKind::vertical, .success = 0}) + mark({.kind = PointKind::horizontal, .success = 0}),
            "The correction may fail");
  }
  if (const std::size_t stride = stride_of(map, *site.navigation); stride > 1) {
    items += fmt::format("<li class=\"note\">One in {} of {} points is drawn, and those of the route.</li>\n", stride,
                         whole(site.navigation->points.size()));
  }
  return items;
}

}  // namespace alate
