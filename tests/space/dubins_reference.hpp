// Dubins' words once more, written apart from the kernels: the formulas of Shkel, Lumelsky 2001, all six of them, each
// angle brought into [0, 2 pi) as it comes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "space/dubins/dubins_path.hpp"

namespace alate::reference {

template <class Real>
Real mod_2pi(Real angle) {
  constexpr Real kTurn = 2 * std::numbers::pi_v<Real>;
  return angle - kTurn * std::floor(angle / kTurn);
}

/// Start and goal on the x axis, d radii apart, with headings alpha and beta.
template <class Real>
struct Normal {
  Real d, alpha, beta;
};

template <class Real>
Normal<Real> normal_form(const PlanarPose& from, const PlanarPose& to, double radius) {
  const Real dx = static_cast<Real>(to.x) - static_cast<Real>(from.x);
  const Real dy = static_cast<Real>(to.y) - static_cast<Real>(from.y);
  const Real direction = std::atan2(dy, dx);
  return {.d = std::hypot(dx, dy) / radius, .alpha = from.heading - direction, .beta = to.heading - direction};
}

template <class Real>
Real lsl(const Normal<Real>& n) {
  const Real x = n.d + std::sin(n.alpha) - std::sin(n.beta);
  const Real y = std::cos(n.beta) - std::cos(n.alpha);
  const Real straight = std::atan2(y, x);
  return mod_2pi(straight - n.alpha) + std::hypot(x, y) + mod_2pi(n.beta - straight);
}

template <class Real>
Real lsr(const Normal<Real>& n) {
  const Real x = n.d + std::sin(n.alpha) + std::sin(n.beta);
  const Real y = -std::cos(n.alpha) - std::cos(n.beta);
  const Real square = x * x + y * y - 4;
  if (square < 0) return std::numeric_limits<Real>::infinity();
  const Real p = std::sqrt(square);
  const Real straight = std::atan2(y, x) - std::atan2(Real{-2}, p);
  return mod_2pi(straight - n.alpha) + p + mod_2pi(straight - n.beta);
}

template <class Real>
Real lrl(const Normal<Real>& n) {
  const Real x = n.d + std::sin(n.alpha) - std::sin(n.beta);
  const Real y = std::cos(n.beta) - std::cos(n.alpha);
  const Real cosine = 1 - (x * x + y * y) / 8;
  if (cosine < -1) return std::numeric_limits<Real>::infinity();
  const Real p = 2 * std::numbers::pi_v<Real> - std::acos(cosine);
  const Real t = mod_2pi(std::atan2(y, x) - n.alpha + p / 2);
  return t + p + mod_2pi(n.beta - n.alpha - t + p);
}

/// Length of each word in metres, in the order of DubinsWord; infinite if there is no such path.
template <class Real>
std::array<Real, 6> word_lengths(const PlanarPose& from, const PlanarPose& to, double radius) {
  const auto left = normal_form<Real>(from, to, radius);
  const Normal<Real> right{left.d, -left.alpha, -left.beta};
  std::array lengths{lsl(left), lsl(right), lsr(left), lsr(right), lrl(left), lrl(right)};
  for (Real& length : lengths) length *= radius;
  return lengths;
}

template <class Real = long double>
double shortest(const PlanarPose& from, const PlanarPose& to, double radius) {
  return static_cast<double>(std::ranges::min(word_lengths<Real>(from, to, radius)));
}

}  // namespace alate::reference
