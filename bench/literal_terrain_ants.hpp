// Ants on a terrain lattice word for word, as a baseline: candidates, angles, distances and powers anew at every step.
// Ground heights stand in an array, and S asks of nodes only, so the literal ant looks at no leg.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "alate/data/peaks.hpp"

namespace alate::bench {

class LiteralTerrainAnt {
 public:
  static constexpr int kCells = 51;   ///< Along x and y, 1 km each.
  static constexpr int kLevels = 16;  ///< Of 200 m.

  explicit LiteralTerrainAnt(const PeakGround& ground) : tau_(std::size_t{kCells} * kCells * kLevels) {
    for (int x = 0; x < kCells; ++x)
      for (int y = 0; y < kCells; ++y) ground_[index(x)][index(y)] = ground.height({x * 1000.0, y * 1000.0}) / 1000;
    for (auto& row : tau_) row.fill(1);
  }

  /// Steps until the plane before the goal's, or a dead end.
  std::size_t walk(std::mt19937_64& random) {
    path_.assign(1, {0, 0, 5});
    while (path_.back().x < kCells - 2 && move(random)) {
    }
    return path_.size() - 1;
  }

 private:
  static constexpr double kAlpha = 1;
  static constexpr double kBeta = 2;
  static constexpr double kLevel = 0.2;
  struct Node {
    int x, y, level;
  };
  struct Option {
    Node to{};
    double chance = 0;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static std::size_t row(const Node& at) { return (index(at.x) * kCells + index(at.y)) * kLevels + index(at.level); }

  bool is_candidate(const Node& to) const {
    const Node& at = path_.back();
    if (to.y < 0 || to.y >= kCells || to.level < 0 || to.level >= kLevels) return false;
    if (to.level * kLevel < ground_[index(to.x)][index(to.y)] + 0.1) return false;  // eq. (11)
    const double dy = to.y - at.y;
    const double pitch = std::atan(std::abs(to.level - at.level) * kLevel / std::sqrt(1 + dy * dy));
    if (pitch > 45 * std::numbers::pi / 180) return false;  // eq. (5)
    if (path_.size() < 2) return true;
    const double before = at.y - path_[path_.size() - 2].y;
    const double cosine = (1 + before * dy) / (std::sqrt(1 + before * before) * std::sqrt(1 + dy * dy));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) <= 60 * std::numbers::pi / 180;  // eq. (6)
  }

  /// S M D, eqs. (11)-(13).
  double eta(const Node& to) const {
    const Node& at = path_.back();
    const double height = to.level * kLevel;
    const double dy = to.y - at.y;
    const double dh = (to.level - at.level) * kLevel;
    const double rest_x = kCells - 1 - to.x;
    const double rest_y = kCells - 1 - to.y;
    const double rest_h = 1 - height;
    return 1 / (1 + height) /
           (std::sqrt(1 + dy * dy + dh * dh) + std::sqrt(1 + rest_x * rest_x + rest_y * rest_y + rest_h * rest_h));
  }

  bool move(std::mt19937_64& random) {
    const Node at = path_.back();
    options_.clear();
    double sum = 0;
    std::size_t k = 0;
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dh = -2; dh <= 2; ++dh, ++k) {
        const Node to{at.x + 1, at.y + dy, at.level + dh};
        if (!is_candidate(to)) continue;
        options_.push_back({to, std::pow(tau_[row(at)][k], kAlpha) * std::pow(eta(to), kBeta)});
        sum += options_.back().chance;
      }
    }
    if (options_.empty()) return false;
    double left = std::uniform_real_distribution<double>(0, sum)(random);
    std::size_t drawn = 0;
    while (drawn + 1 < options_.size() && left >= options_[drawn].chance) left -= options_[drawn++].chance;
    path_.push_back(options_[drawn].to);
    return true;
  }

  std::array<std::array<double, kCells>, kCells> ground_{};
  std::vector<std::array<double, 25>> tau_;
  std::vector<Node> path_;
  std::vector<Option> options_;
};

}  // namespace alate::bench
