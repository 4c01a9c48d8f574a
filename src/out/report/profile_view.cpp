#include "out/report/profile_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "out/report/axis.hpp"
#include "out/report/number_words.hpp"
#include "out/report/profile.hpp"
#include "out/report/svg.hpp"

namespace alate {

namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 430;
const PlotArea kArea{{78, 46}, {902, 320}};
constexpr int kSamples = 600;

using Samples = std::vector<ProfileSample>;

/// Highest allowed height over the sample; nothing where no ceiling is given.
std::optional<double> ceiling_at(const Band& band, const ProfileSample& sample) {
  std::optional<double> ceiling = band.ceiling_amsl_m;
  if (band.ceiling_agl_m && sample.ground_m) {
    const double above = *sample.ground_m + *band.ceiling_agl_m;
    ceiling = std::min(ceiling.value_or(above), above);
  }
  return ceiling;
}

/// The whole height of a voxel map.
Scale height_scale(const VoxelGrid& voxels, const Samples& samples) {
  double low = 0;
  double high = voxels.extent().z() * voxels.cell_m;
  for (const ProfileSample& sample : samples) {
    low = std::min(low, sample.position.z());
    high = std::max(high, sample.position.z());
  }
  return {low, high, kArea.corner.y() + kArea.size.y(), kArea.corner.y()};
}

/// From the lowest ground to above the highest of route, ground and (unless far above) ceiling.
Scale height_scale(const Band& band, const Samples& samples) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double ceiling = high;
  for (const ProfileSample& sample : samples) {
    const double ground = sample.ground_m.value_or(sample.position.z());
    low = std::min({low, ground, sample.position.z()});
    high = std::max({high, ground, sample.position.z()});
    ceiling = std::max(ceiling, ceiling_at(band, sample).value_or(ceiling));
  }
  const double span = std::max(high - low, 10.0);
  high = std::max(high + 0.15 * span, std::min(ceiling, high + 0.5 * span));
  low -= 0.08 * span;
  return {low, high, kArea.corner.y() + kArea.size.y(), kArea.corner.y()};
}

struct Drawing {
  Svg& svg;
  Axes axes;
  double unit_m = 1;  ///< Of the x axis: 1 or 1000.

  Vec2 at(double along_m, double height_m) const { return {axes.x(along_m / unit_m), axes.y(height_m)}; }
};

/// Calls `draw(begin, end)` for every run of samples with known ground.
template <class Draw>
void for_known_runs(const Samples& samples, const Draw& draw) {
  for (auto begin = samples.begin(); begin != samples.end();) {
    const auto known = [](const ProfileSample& s) { return s.ground_m.has_value(); };
    begin = std::find_if(begin, samples.end(), known);
    const auto end = std::find_if_not(begin, samples.end(), known);
    if (end - begin > 1) draw(begin, end);
    begin = end;
  }
}

void draw_band(const Drawing& drawing, const Band& band, const Samples& samples) {
  for_known_runs(samples, [&](auto begin, auto end) {
    std::vector<Vec2> lower;
    std::vector<Vec2> upper;
    for (auto sample = begin; sample != end; ++sample) {
      const double ceiling = ceiling_at(band, *sample).value_or(drawing.axes.y.to);
      const double floor = *sample->ground_m + band.clearance_m;
      lower.push_back(drawing.at(sample->along_m, floor));
      upper.push_back(drawing.at(sample->along_m, std::max(ceiling, floor)));
    }
    std::vector<Vec2> outline = lower;
    outline.insert(outline.end(), upper.rbegin(), upper.rend());
    drawing.svg.polygon(outline, "band");
    drawing.svg.polyline(lower, "limit");
    if (band.ceiling_agl_m || band.ceiling_amsl_m) drawing.svg.polyline(upper, "limit");
  });
}

void draw_ground(const Drawing& drawing, const Samples& samples) {
  for_known_runs(samples, [&](auto begin, auto end) {
    std::vector<Vec2> outline{drawing.at(begin->along_m, drawing.axes.y.from)};
    for (auto sample = begin; sample != end; ++sample)
      outline.push_back(drawing.at(sample->along_m, *sample->ground_m));
    outline.push_back(drawing.at((end - 1)->along_m, drawing.axes.y.from));
    drawing.svg.polygon(outline, "ground");
  });
}

void draw_unknown(const Drawing& drawing, const Samples& samples) {
  for (auto begin = samples.begin(); begin != samples.end();) {
    const auto known = [](const ProfileSample& s) { return s.ground_m.has_value(); };
    begin = std::find_if_not(begin, samples.end(), known);
    const auto end = std::find_if(begin, samples.end(), known);
    if (begin != end) {
      const Vec2 corner{drawing.at(begin->along_m, 0).x(), kArea.corner.y()};
      drawing.svg.rect(corner, {std::max(2.0, drawing.at((end - 1)->along_m, 0).x() - corner.x()), kArea.size.y()},
                       "unknown", "ground not known");
    }
    begin = end;
  }
}

/// The blocked cells above and below the route, column by column.
void draw_voxels(const Drawing& drawing, const VoxelGrid& voxels, const Samples& samples) {
  const auto column_of = [&](const ProfileSample& sample) {
    const Vec3& at = sample.position;
    return voxels.cell_at({at.x(), at.y(), voxels.cell_m / 2});
  };
  for (auto begin = samples.begin(); begin + 1 < samples.end();) {
    const auto column = column_of(*begin);
    const auto end = std::find_if(begin + 1, samples.end() - 1, [&](const auto& s) { return column_of(s) != column; });
    for (int z = 0; column && z < voxels.size()[2];) {
      const auto is_blocked = [&](int at) {
        return at < voxels.size()[2] && voxels.blocked_at({(*column)[0], (*column)[1], at});
      };
      int top = z;
      while (is_blocked(top)) ++top;
      if (top > z) {
        const Vec2 corner = drawing.at(begin->along_m, top * voxels.cell_m);
        drawing.svg.rect(corner, drawing.at(end->along_m, z * voxels.cell_m) - corner, "voxel");
      }
      z = top + 1;
    }
    begin = end;
  }
}

void draw_threat_spans(const Drawing& drawing, const std::vector<ThreatSpan>& spans) {
  for (const ThreatSpan& span : spans) {
    const Vec2 corner{drawing.at(span.from_m, 0).x(), kArea.corner.y()};
    const double width = std::max(2.0, drawing.at(span.to_m, 0).x() - corner.x());
    drawing.svg.rect(corner, {width, kArea.size.y()}, "threat-span", "inside the radius of " + span.name);
    drawing.svg.text(corner + Vec2{width / 2, 18}, span.name, "label name", Anchor::middle);
  }
}

void draw_route(const Drawing& drawing, const Samples& samples) {
  std::vector<Vec2> line;
  for (const ProfileSample& sample : samples) line.push_back(drawing.at(sample.along_m, sample.position.z()));
  drawing.svg.polyline(line, "halo");
  drawing.svg.polyline(line, "route");
}

void draw_lowest(const Drawing& drawing, const ProfileSample& sample) {
  const Vec2 above = drawing.at(sample.along_m, sample.position.z());
  const Vec2 below = drawing.at(sample.along_m, *sample.ground_m);
  drawing.svg.line(above, below, "lowest");
  drawing.svg.circle(above, 4, "lowest-dot");
  const bool right_half = above.x() > kArea.corner.x() + kArea.size.x() / 2;
  drawing.svg.text(above + Vec2{right_half ? -10 : 10, -14},
                   fmt::format("lowest: {} above ground", quantity(sample.position.z() - *sample.ground_m, "m")),
                   "label", right_half ? Anchor::end : Anchor::start);
}

std::string key(std::string_view swatch, const std::string& text) {
  return fmt::format("<li><span class=\"swatch {}\"></span>{}</li>\n", swatch, text);
}

struct ProfileKey {
  const Site& site;
  bool threats = false;
  bool unknown = false;
  double exaggeration = 1;
};

std::string legend(const ProfileKey& shown) {
  const Band& band = shown.site.band;
  std::string items = key("s-route", "Route");
  if (shown.site.has_ground()) {
    items += key("s-ground", "Ground");
    std::string limits = fmt::format("Allowed: {:.0f} m or more above ground", band.clearance_m);
    if (band.ceiling_agl_m) limits += fmt::format(", at most {:.0f} m above ground", *band.ceiling_agl_m);
    if (band.ceiling_amsl_m) limits += fmt::format(", at most {:.0f} m above sea level", *band.ceiling_amsl_m);
    items += key("s-band", limits);
  }
  if (shown.site.voxels) items += key("s-blocked", "Blocked cells above and below the route");
  if (shown.threats) items += key("s-threat", "Inside a threat's radius");
  if (shown.unknown) items += key("s-unknown", "Ground not known");
  if (shown.exaggeration > 1.5)
    items += fmt::format("<li class=\"note\">Heights are drawn {:.0f} times larger than distances.</li>\n",
                         shown.exaggeration);
  return fmt::format("<ul class=\"key\">\n{}</ul>\n", items);
}

}  // namespace

std::string profile_figure(const Result& result) {
  const Site& site = result.site;
  if (result.plan.route.states.size() < 2) return {};
  const Samples samples = sample_profile(site, result.plan.route, kSamples);
  const double length_m = std::max(samples.back().along_m, 1.0);
  const bool in_km = length_m >= 2000;
  const double unit_m = in_km ? 1000 : 1;
  Svg svg(kWidth, kHeight, "Height of the route and of the ground below it");
  const Drawing drawing{svg,
                        {.area = kArea,
                         .x = {0, length_m / unit_m, kArea.corner.x(), kArea.corner.x() + kArea.size.x()},
                         .y = site.voxels ? height_scale(*site.voxels, samples) : height_scale(site.band, samples),
                         .x_title = in_km ? "Distance flown, km" : "Distance flown, m",
                         .y_title = site.voxels ? "z, m" : "Height above sea level, m"},
                        unit_m};
  const auto spans = threat_spans(site, samples);
  draw_axes(svg, drawing.axes);
  svg.begin_clip(kArea.corner, kArea.size);
  if (site.voxels) draw_voxels(drawing, *site.voxels, samples);
  if (site.has_ground()) draw_band(drawing, site.band, samples);
  draw_threat_spans(drawing, spans);
  if (site.has_ground()) {
    draw_unknown(drawing, samples);
    draw_ground(drawing, samples);
  }
  draw_route(drawing, samples);
  const auto lowest = lowest_clearance(result, samples);
  if (lowest) draw_lowest(drawing, *lowest);
  svg.end_clip();
  const Scale& y = drawing.axes.y;
  const double exaggeration = kArea.size.y() / (y.to - y.from) / (kArea.size.x() / length_m);
  const bool unknown = std::ranges::any_of(samples, [](const ProfileSample& s) { return !s.ground_m; });
  return fmt::format("<figure>\n{}{}</figure>\n", svg.str(),
                     legend({.site = site,
                             .threats = !spans.empty(),
                             .unknown = site.has_ground() && unknown,
                             .exaggeration = exaggeration}));
}

}  // namespace alate
