// What a search asks of a space.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "space/candidates.hpp"

namespace alate {

/// A space owns the meaning of its State; searches are templates over it and keep states by value.
template <class S>
concept Space = requires(const S& space, const typename S::State& state, Candidates& out, std::size_t k, double scale) {
  { space.start() } -> std::convertible_to<typename S::State>;
  /// Actions of every state: the size of `out` after expand.
  { space.actions() } -> std::convertible_to<std::size_t>;
  /// Costs and guides of all candidates; the cheap tests of K are done, `is_free` is not.
  { space.expand(state, out) };
  /// Does candidate k end within the goal's tolerance?
  { space.arrives(out, k) } -> std::convertible_to<bool>;
  /// The state that candidate k of `state` leads to.
  { space.next(state, k) } -> std::convertible_to<typename S::State>;
  /// The costly test of K: may the leg between two states in a row be flown?
  { space.is_free(state, state) } -> std::convertible_to<bool>;
  { space.is_goal(state) } -> std::convertible_to<bool>;
  /// No way from here to the goal costs less.
  { space.lower_bound(state) } -> std::convertible_to<double>;
  /// States of one bin are near enough to each other that a search may keep only the best. Larger scale, larger bins.
  { space.bin(state, scale) } -> std::convertible_to<std::uint64_t>;
  { space.step_limit() } -> std::convertible_to<std::size_t>;
};

}  // namespace alate
