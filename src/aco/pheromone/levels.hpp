// How high trails are: evaporation, bounds, and what an unknown place has. Independent of how places are stored.
//
// Evaporation is lazy: what a place keeps is its trail divided by (1 - rho)^age of the colony, so one number that is
// multiplied at every evaporation lowers all trails at once. Before that number gets too small the stored values are
// rescaled, once in some hundred iterations.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

namespace alate {

/// What is stored for a place; 0: unknown.
using StoredTrail = float;

struct TrailRule {
  double evaporation = 0.8;     ///< rho, 0 to 1.
  double initial = 1;           ///< Of an unknown place.
  bool unknown_decays = false;  ///< As known ones do (MAX-MIN), or stays at `initial` for ever, eq. (35).
};

class TrailLevels {
 public:
  explicit TrailLevels(const TrailRule& rule)
      : kept_(static_cast<float>(1 - rule.evaporation)),
        unknown_decays_(rule.unknown_decays),
        unknown_(static_cast<float>(rule.initial)) {}

  float read(StoredTrail stored) const {
    const float level = stored == 0 ? unknown_ : stored * scale_;
    const float enough = level < least_ ? least_ : level;
    return enough < most_ ? enough : most_;
  }

  /// Of several, in a vector of the GNU kind.
  template <class Vector>
    requires(!std::is_arithmetic_v<Vector>)
  Vector read(const Vector& stored) const {
    constexpr Vector kNone{};
    const Vector level = stored == 0 ? kNone + unknown_ : stored * scale_;
    const Vector enough = level < least_ ? kNone + least_ : level;
    return enough < most_ ? enough : kNone + most_;
  }

  /// What to store for a level. A known place never stores 0.
  StoredTrail stored(double level) const {
    const float bounded = std::clamp(static_cast<float>(level), least_, most_);
    return std::max(bounded / scale_, kKnown);
  }

  /// Eq. (2), first term, for all places at once. `rescale` changes every stored value by a function.
  template <class Rescale>
  void evaporate(const Rescale& rescale) {
    scale_ *= kept_;
    if (unknown_decays_) unknown_ = std::max(unknown_ * kept_, kKnown);
    if (scale_ > kLeastScale) return;
    const float scale = scale_;
    rescale([scale](StoredTrail& value) { value = std::max(value * scale, kKnown); });
    scale_ = 1;
  }

  void set_bounds(double least, double most) {
    least_ = static_cast<float>(least);
    most_ = static_cast<float>(most);
  }
  void set_evaporation(double rho) { kept_ = static_cast<float>(1 - rho); }
  void set_unknown(double level) { unknown_ = static_cast<float>(level); }
  bool unknown_decays() const { return unknown_decays_; }

 private:
  static constexpr float kKnown = std::numeric_limits<float>::min();
  static constexpr float kLeastScale = 1e-12F;

  float kept_;  ///< 1 - rho.
  bool unknown_decays_;
  float unknown_;
  float scale_ = 1;
  float least_ = 0;
  float most_ = std::numeric_limits<float>::max();
};

}  // namespace alate
