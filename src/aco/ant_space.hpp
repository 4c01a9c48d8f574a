// What a colony asks of a space.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <span>

#include "space/choices.hpp"

namespace alate {

/// What the loop itself asks.
template <class S>
concept ColonySpace = requires(const S& space, std::span<const std::uint32_t> actions) {
  /// Exact cost until the first arrival; nothing if a move may not be flown, or none arrives.
  { space.fly(actions) } -> std::convertible_to<std::optional<FlownActions>>;
};

/// What ants ask that look at arrays of choices.
template <class S>
concept AntSpace =
    ColonySpace<S> && requires(const S& space, const typename S::State& state, Choices& out, std::size_t k) {
      { space.start() } -> std::convertible_to<typename S::State>;
      { space.actions() } -> std::convertible_to<std::size_t>;
      { space.step_limit() } -> std::convertible_to<std::size_t>;
      /// Places, costs and guides of all choices. The cheap tests of K are done, `is_free` is not.
      { space.look(state, out) };
      { space.next(state, k) } -> std::convertible_to<typename S::State>;
      /// The costly test of K, asked only of the choice that an ant is about to make.
      { space.is_free(state, state) } -> std::convertible_to<bool>;
      { space.is_goal(state) } -> std::convertible_to<bool>;
      /// Where a state is, as the choices give it.
      { space.place(state) } -> std::convertible_to<Eigen::Vector3f>;
    };

}  // namespace alate
