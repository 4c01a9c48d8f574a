// The pheromone model: levels on the places of a store.
//
// A store finds what is stored for a key (`find`, which does not change the store) and makes a place for it (`at`).
// Stores of places also name them (`name`) and find all choices of an ant at once (`find_all`).
// Ants only read, at the same time; changes come between iterations, from one thread and in order of ants.
#pragma once

#include <algorithm>
#include <concepts>
#include <utility>

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"
#include "aco/weights.hpp"

namespace alate {

template <class T>
concept TrailStore = requires(const T& store, T& changing, TrailKey key) {
  { store.find(key) } -> std::convertible_to<StoredTrail>;
  { changing.at(key) } -> std::same_as<StoredTrail&>;
  {
    changing.for_each([](StoredTrail&) {})
  };  // all known places, in any order
};

template <class T>
concept PlaceStore = TrailStore<T> && requires(const T& store, Choices& choices, float x) {
  { store.find_all(choices) };  // fills choices.trail
  { store.name(x, x, x) } -> std::same_as<TrailKey>;
};

template <TrailStore Store>
class Trail {
 public:
  Trail(Store store, const TrailRule& rule) : store_(std::move(store)), levels_(rule) {}

  /// Multiplies the weights by tau_k^alpha: eq. (35), the stored value, or that of an unknown place.
  void weigh(int alpha, Choices& choices) const
    requires PlaceStore<Store>
  {
    if (alpha == 0) return;
    store_.find_all(choices);
    multiply_by_trail(levels_, alpha, choices);
  }

  TrailKey name(float x, float y, float z) const
    requires PlaceStore<Store>
  {
    return store_.name(x, y, z);
  }

  /// Names the nodes of a route that was changed after the walk.
  template <class Space>
  void name_route(const Space& space, Ant& ant) const
    requires PlaceStore<Store>
  {
    ant.keys.clear();
    auto state = space.start();
    for (const std::uint32_t k : ant.actions) {
      state = space.next(state, k);
      const Eigen::Vector3f place = space.place(state);
      ant.keys.push_back(store_.name(place.x(), place.y(), place.z()));
    }
  }

  bool known(TrailKey key) const { return store_.find(key) != 0; }
  float level(TrailKey key) const { return levels_.read(store_.find(key)); }

  /// The place becomes a member of N, eq. (28), with the level of an unknown one.
  void join(TrailKey key) {
    if (levels_.unknown_decays()) return;
    StoredTrail& stored = store_.at(key);
    if (stored == 0) stored = levels_.stored(static_cast<double>(levels_.read(stored)));
  }
  void add(TrailKey key, double amount) {
    StoredTrail& stored = store_.at(key);
    stored = levels_.stored(static_cast<double>(levels_.read(stored)) + amount);
  }
  /// tau <- (1 - share) tau + share * target.
  void blend(TrailKey key, double share, double target) {
    StoredTrail& stored = store_.at(key);
    stored = levels_.stored((1 - share) * static_cast<double>(levels_.read(stored)) + share * target);
  }
  void evaporate() {
    levels_.evaporate([this](const auto& change) { store_.for_each(change); });
  }
  TrailLevels& levels() { return levels_; }
  const TrailLevels& levels() const { return levels_; }
  const Store& store() const { return store_; }
  Store& store() { return store_; }
  /// Lowest and highest trail, that of unknown places among them.
  std::pair<double, double> extremes() {
    auto low = levels_.read(0);
    auto high = low;
    store_.for_each([&](const StoredTrail& one) {
      low = std::min(low, levels_.read(one));
      high = std::max(high, levels_.read(one));
    });
    return {static_cast<double>(low), static_cast<double>(high)};
  }
  /// All trails, on places known or not, get one level.
  void reset(double level) {
    levels_.set_unknown(level);
    store_.for_each([&](StoredTrail& one) { one = levels_.stored(level); });
  }

 private:
  Store store_;
  TrailLevels levels_;
};

}  // namespace alate
