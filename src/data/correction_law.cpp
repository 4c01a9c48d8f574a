#include "data/correction_law.hpp"

#include <cmath>

#include "alate/core/stream.hpp"

namespace alate {

namespace {

constexpr double kContestWidth_m = 100'000;
constexpr double kHeight_m = 10'000;

double centimetres(double metres) { return std::round(metres * 100) / 100; }

Navigation limits_of(CorrectionLaw law) {
  Navigation navigation{.drift_vertical = 0.001, .drift_horizontal = 0.001, .residual = 5};
  if (law == CorrectionLaw::set1) {
    navigation.at_vertical = {.vertical = 25, .horizontal = 15};
    navigation.at_horizontal = {.vertical = 20, .horizontal = 25};
    navigation.theta = 30;
  } else {
    navigation.at_vertical = {.vertical = 20, .horizontal = 10};
    navigation.at_horizontal = {.vertical = 15, .horizontal = 20};
    navigation.theta = 20;
  }
  return navigation;
}

}  // namespace

CorrectionField draw_corrections(CorrectionLaw law, int points, std::uint64_t seed) {
  const double contest_points = law == CorrectionLaw::set1 ? 611 : 325;
  const double width = centimetres(kContestWidth_m * std::sqrt(points / contest_points));
  CorrectionField field{.navigation = limits_of(law),
                        .start = {0, centimetres(width / 2), kHeight_m / 2},
                        .goal = {width, centimetres(0.6 * width), kHeight_m / 2}};
  field.navigation.start_id = 0;
  field.navigation.goal_id = points + 1;
  field.navigation.points.reserve(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    Stream stream(seed, 0, static_cast<std::uint64_t>(i));
    const double x = centimetres(width * stream.uniform());
    const double y = centimetres(width * stream.uniform());
    const double z = centimetres(kHeight_m * stream.uniform());
    field.navigation.points.push_back({.id = i + 1,
                                       .position = {x, y, z},
                                       .kind = i % 2 == 0 ? PointKind::vertical : PointKind::horizontal,
                                       .success = i % 8 < 2 ? 0.8 : 1.0});
  }
  return field;
}

}  // namespace alate
