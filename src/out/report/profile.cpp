#include "out/report/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "out/route_points.hpp"

namespace alate {

namespace {

ProfileSample sample_at(const Site& site, const Vec3& position, double along_m) {
  const auto above = height_above_ground(site, position);
  return {along_m, position, above ? std::optional(position.z() - *above) : std::nullopt};
}

double planar_length(const std::vector<Vec3>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += Segment{line[i - 1], line[i]}.planar_length();
  return sum;
}

bool is_inside(const Threat& threat, const Vec3& at) {
  if (threat.shape == Threat::Shape::sphere) return (at - threat.center).norm() < threat.radius_m;
  return (at - threat.center).head<2>().norm() < threat.radius_m && at.z() >= threat.floor_m && at.z() <= threat.top_m;
}

}  // namespace

std::vector<ProfileSample> sample_profile(const Site& site, const Route& route, int count) {
  const std::vector<Vec3> line = drawn_line(route);
  if (line.empty()) return {};
  std::vector<ProfileSample> samples{sample_at(site, line.front(), 0)};
  const double spacing = std::max(planar_length(line) / count, 1e-3);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Segment leg{line[i - 1], line[i]};
    const double begin = samples.back().along_m;
    const int pieces = std::max(1, static_cast<int>(std::ceil(leg.planar_length() / spacing)));
    for (int k = 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      samples.push_back(sample_at(site, leg.at(t), begin + t * leg.planar_length()));
    }
  }
  return samples;
}

std::vector<ThreatSpan> threat_spans(const Site& site, const std::vector<ProfileSample>& samples) {
  std::vector<ThreatSpan> spans;
  for (const Threat& threat : site.threats) {
    bool open = false;
    for (const ProfileSample& sample : samples) {
      const bool inside = is_inside(threat, sample.position);
      if (inside && !open) spans.push_back({threat.name, sample.along_m, sample.along_m});
      if (inside) spans.back().to_m = sample.along_m;
      open = inside;
    }
  }
  return spans;
}

std::optional<ProfileSample> lowest_clearance(const Result& result, const std::vector<ProfileSample>& samples) {
  const auto& margins = result.verdict.margins;
  const auto judged = std::ranges::find(margins, "terrain_clearance", &Margin::rule);
  if (judged != margins.end()) {
    const auto distance = [&](const ProfileSample& s) { return (s.position - judged->where).norm(); };
    const double along = std::ranges::min_element(samples, {}, distance)->along_m;
    const ProfileSample found = sample_at(result.site, judged->where, along);
    return found.ground_m ? std::optional(found) : std::nullopt;
  }
  const auto above = [](const ProfileSample& s) {
    return s.ground_m ? s.position.z() - *s.ground_m : std::numeric_limits<double>::infinity();
  };
  const auto lowest = std::ranges::min_element(samples, {}, above);
  return lowest->ground_m ? std::optional(*lowest) : std::nullopt;
}

}  // namespace alate
