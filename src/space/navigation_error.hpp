// How navigation errors grow and are reset (Zhou et al. 2020, section 2, with the recursion mended: the error that a
// point does not reset is carried on).
#pragma once

#include <algorithm>
#include <optional>

#include "alate/data/site.hpp"

namespace alate {

/// Both errors, in units. The start has none.
struct NavigationError {
  double vertical = 0;
  double horizontal = 0;
};

/// Errors on arrival after a leg of `length_m`.
inline NavigationError grown(const Navigation& navigation, const NavigationError& error, double length_m) {
  return {.vertical = error.vertical + navigation.drift_vertical * length_m,
          .horizontal = error.horizontal + navigation.drift_horizontal * length_m};
}

/// May a point of this kind (or the goal) be used with these errors on arrival?
inline bool keeps_limits(const Navigation& navigation, const NavigationError& error, PointKind kind) {
  if (kind == PointKind::end) return error.vertical < navigation.theta && error.horizontal < navigation.theta;
  const Navigation::Limits& most = kind == PointKind::vertical ? navigation.at_vertical : navigation.at_horizontal;
  return error.vertical <= most.vertical && error.horizontal <= most.horizontal;
}

/// Errors after a correction that works. The goal corrects nothing.
inline NavigationError corrected(NavigationError error, PointKind kind) {
  if (kind == PointKind::vertical) error.vertical = 0;
  if (kind == PointKind::horizontal) error.horizontal = 0;
  return error;
}

/// Errors after a correction that fails: what it should have reset is left at min(error, residual).
inline NavigationError failed(const Navigation& navigation, NavigationError error, PointKind kind) {
  if (kind == PointKind::vertical && error.vertical > navigation.residual) error.vertical = navigation.residual;
  if (kind == PointKind::horizontal && error.horizontal > navigation.residual) error.horizontal = navigation.residual;
  return error;
}

/// Flies a leg and is corrected: the errors after it, or nothing if they break a limit on arrival.
inline std::optional<NavigationError> arrive(const Navigation& navigation, const NavigationError& before,
                                             double length_m, PointKind kind) {
  const NavigationError on_arrival = grown(navigation, before, length_m);
  if (!keeps_limits(navigation, on_arrival, kind)) return std::nullopt;
  return corrected(on_arrival, kind);
}

/// More than rounding adds to an error on any route, units.
inline constexpr double kErrorSlack = 1e-9;

/// The same in one number. After a correction one error is 0; the other, `error`, is all there is to know. A leg from
/// a point of one kind to a point of another grows a fresh error from 0 and carries the other on. The start is as good
/// as a point of either kind with error 0. Bits agree with `arrive`.
struct ReducedLeg {
  double fresh_rate = 0;    ///< Units a metre.
  double carried_rate = 0;  ///< Units a metre.
  double fresh_most = 0;    ///< Limits on arrival, at most. The goal's limit is the number below theta.
  double carried_most = 0;
  bool carries_on = false;  ///< The target resets the fresh error (same kind): the carried one stays.

  bool keeps_limits(double error, double length_m) const {
    return fresh_rate * length_m <= fresh_most && error + carried_rate * length_m <= carried_most;
  }
  double after(double error, double length_m) const {
    return carries_on ? error + carried_rate * length_m : fresh_rate * length_m;
  }
  /// No longer leg keeps the limits; a hair more than the exact value, never less. Negative: none does.
  double reach_m(double error) const;

  /// The same seen from the target. Where `most_after` is the most error there from which the goal can be reached: the
  /// most error at the source; negative where the leg cannot be used at all. Optimistic by kErrorSlack, so that what
  /// follows from it is a bound whatever rounding does.
  double most_before(double most_after, double length_m) const {
    const double left = carried_most - carried_rate * length_m;
    if (fresh_rate * length_m > fresh_most || left < -kErrorSlack) return -1;
    if (carries_on) return std::min(left, most_after - carried_rate * length_m) + kErrorSlack;
    return fresh_rate * length_m <= most_after + kErrorSlack ? left + kErrorSlack : -1;
  }
  /// No longer leg leads to the target, as reach_m.
  double reach_back_m(double most_after) const;
};

/// `from` vertical or horizontal, `to` vertical, horizontal or end.
ReducedLeg reduced_leg(const Navigation& navigation, PointKind from, PointKind to);

}  // namespace alate
