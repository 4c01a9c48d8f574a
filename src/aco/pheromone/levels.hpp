// How high trails are: evaporation, bounds, and what an unknown place has. Independent of how places are stored.
//
// Evaporation is lazy: a cell keeps its value and the time of its last change, and is multiplied by a power of (1 -
// rho) when it is read, so that no sweep over all cells is needed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace alate {

struct TrailCell {
  float value = 0;
  std::uint32_t stamp = 0;  ///< 0: unknown.
};

struct TrailRule {
  double evaporation = 0.8;     ///< rho, 0 to 1.
  double initial = 1;           ///< Of an unknown place.
  bool unknown_decays = false;  ///< As known ones do (MAX-MIN), or stays at `initial` for ever, eq. (35).
};

class TrailLevels {
 public:
  explicit TrailLevels(const TrailRule& rule) : rule_(rule), unknown_(static_cast<float>(rule.initial)) {
    const double kept = 1 - rule.evaporation;
    for (double power = 1; power > kLeastPower && powers_.size() < kMostPowers; power *= kept)
      powers_.push_back(static_cast<float>(power));
    if (kept < 1) powers_.push_back(0);
  }

  float read(const TrailCell& cell) const {
    const std::size_t age = std::min<std::size_t>(now_ - cell.stamp, powers_.size() - 1);
    const float level = cell.stamp == 0 ? unknown_ : cell.value * powers_[age];
    return std::clamp(level, least_, most_);
  }

  void write(TrailCell& cell, double value) const {
    cell = {std::clamp(static_cast<float>(value), least_, most_), now_};
  }

  /// Eq. (2), first term, for all places at once.
  void evaporate() {
    ++now_;
    if (rule_.unknown_decays) unknown_ *= powers_[std::min<std::size_t>(1, powers_.size() - 1)];
  }

  void set_bounds(double least, double most) {
    least_ = static_cast<float>(least);
    most_ = static_cast<float>(most);
  }
  void set_unknown(double level) { unknown_ = static_cast<float>(level); }
  /// Does it matter whether a place without a deposit is known?
  bool unknown_decays() const { return rule_.unknown_decays; }

 private:
  static constexpr std::size_t kMostPowers = 100000;
  static constexpr double kLeastPower = 1e-37;  ///< About the least that a float holds.

  TrailRule rule_;
  std::vector<float> powers_;  ///< (1 - rho)^age.
  std::uint32_t now_ = 1;
  float unknown_;
  float least_ = 0;
  float most_ = std::numeric_limits<float>::max();
};

}  // namespace alate
