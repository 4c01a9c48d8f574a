#include "data/gradient_noise.hpp"

#include <array>

namespace alate {

namespace {

constexpr double kDiagonal = 0.70710678118654752;
constexpr std::array<std::array<double, 2>, 8> kDirections{{{1, 0},
                                                            {kDiagonal, kDiagonal},
                                                            {0, 1},
                                                            {-kDiagonal, kDiagonal},
                                                            {-1, 0},
                                                            {-kDiagonal, -kDiagonal},
                                                            {0, -1},
                                                            {kDiagonal, -kDiagonal}}};

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
double mix(double a, double b, double part) { return a + part * (b - a); }

}  // namespace

GradientNoise::GradientNoise(double wavelength_m, double width_m, Stream random)
    : per_wavelength_(1 / wavelength_m), columns_(static_cast<std::size_t>(width_m / wavelength_m) + 2) {
  gradients_.reserve(columns_ * columns_);
  for (std::size_t i = 0; i < columns_ * columns_; ++i) {
    const auto& direction = kDirections[random.below(kDirections.size())];
    gradients_.emplace_back(direction[0], direction[1]);
  }
}

double GradientNoise::operator()(const Vec2& place) const {
  const Vec2 at = place * per_wavelength_;
  const auto column = static_cast<std::size_t>(at.x());
  const auto row = static_cast<std::size_t>(at.y());
  const double u = at.x() - static_cast<double>(column);
  const double v = at.y() - static_cast<double>(row);
  const Vec2* low = &gradients_[row * columns_ + column];
  const Vec2* high = low + columns_;
  const auto ramp = [](const Vec2& slope, double x, double y) { return slope.x() * x + slope.y() * y; };
  const double fade_u = fade(u);
  return mix(mix(ramp(low[0], u, v), ramp(low[1], u - 1, v), fade_u),
             mix(ramp(high[0], u, v - 1), ramp(high[1], u - 1, v - 1), fade_u), fade(v));
}

}  // namespace alate
