// Ants on a grid word for word, as a baseline: neighbours, distances and powers anew at every step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "alate/data/height_grid.hpp"

namespace alate::bench {

using Place = std::pair<int, int>;  ///< Column, row.

class LiteralGridAnt {
 public:
  /// Pheromone of each directed move by cell; `factors`: eqs. (1)-(6), (12) of Yin et al. 2021, else eta = 1 / d_jE.
  LiteralGridAnt(const HeightGrid& grid, Place start, Place goal, bool factors)
      : grid_(grid), start_(std::move(start)), goal_(std::move(goal)), factors_(factors), tau(grid.blocked.size()) {
    for (auto& row : tau) row.fill(20);
  }

  /// Steps until the goal or a dead end.
  std::size_t walk(std::mt19937_64& random) {
    path_.assign(1, start_);
    visited_.assign(grid_.blocked.size(), false);
    visited_[grid_.index(start_.first, start_.second)] = true;
    while (path_.back() != goal_ && move(random)) {
    }
    return path_.size() - 1;
  }

 private:
  static constexpr double kAlpha = 1;
  static constexpr double kBeta = 3;
  struct Option {
    Place to;
    int direction = 0;
    double distance = 1;
    double chance = 0;
  };

  bool is_free(int column, int row) const { return grid_.contains(column, row) && !grid_.blocked_at(column, row); }
  static double apart(const Place& a, const Place& b) {
    const double x = a.first - b.first;
    const double y = a.second - b.second;
    return std::sqrt(x * x + y * y);
  }
  double height(const Place& at) const { return grid_.height_at(at.first, at.second); }

  void list_options() {
    const auto [column, row] = path_.back();
    options_.clear();
    int direction = 0;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (x == 0 && y == 0) continue;
        const int index = direction++;
        if (!is_free(column + x, row + y)) continue;
        if (x != 0 && y != 0 && (!is_free(column + x, row) || !is_free(column, row + y))) continue;
        const Place to{column + x, row + y};
        if (visited_[grid_.index(to.first, to.second)]) continue;
        options_.push_back({.to = to, .direction = index, .distance = x != 0 && y != 0 ? 1.4 : 1});
      }
    }
  }

  double eta(const std::vector<Option>& all, const Option& one) const {
    const Place& at = path_.back();
    double far = 0, near = 1e9, steep = 0, high = -1e9, low = 1e9;
    for (const Option& other : all) {
      far = std::max(far, apart(other.to, goal_));
      near = std::min(near, apart(other.to, goal_));
      steep = std::max(steep, std::abs(height(at) - height(other.to)));
      high = std::max(high, height(at) - height(other.to));
      low = std::min(low, height(at) - height(other.to));
    }
    const double phi = 10 * (far - apart(one.to, goal_)) / (far - near + 0.001) + 1;
    const double v = 10 * (steep - std::abs(height(at) - height(one.to))) / (high - low + 0.001) + 1;
    const auto count = static_cast<double>(all.size());
    double r = 10 / count;
    if (path_.size() > 1) r = one.direction == last_direction_ ? 0.5 * 10 : 0.5 * 10 / count;
    return r + 1 / one.distance + phi + v;
  }

  bool move(std::mt19937_64& random) {
    list_options();
    std::vector<Option>& all = options_;
    if (all.empty()) return false;
    const auto& trails = tau[grid_.index(path_.back().first, path_.back().second)];
    double sum = 0;
    for (Option& one : all) {
      const double look = factors_ ? eta(all, one) : 1 / std::max(apart(one.to, goal_), 0.5);
      const double mu = factors_ ? 1 / (apart(one.to, start_) + apart(one.to, goal_)) : 1;
      one.chance = std::pow(trails[static_cast<std::size_t>(one.direction)], kAlpha) * std::pow(look, kBeta) * mu;
      sum += one.chance;
    }
    double left = std::uniform_real_distribution<double>(0, sum)(random);
    std::size_t k = 0;
    while (k + 1 < all.size() && left >= all[k].chance) left -= all[k++].chance;
    last_direction_ = all[k].direction;
    path_.push_back(all[k].to);
    visited_[grid_.index(all[k].to.first, all[k].to.second)] = true;
    return true;
  }

  const HeightGrid& grid_;
  Place start_;
  Place goal_;
  bool factors_;
  int last_direction_ = -1;
  std::vector<Place> path_;
  std::vector<bool> visited_;
  std::vector<Option> options_;

 public:
  std::vector<std::array<double, 8>> tau;
};

}  // namespace alate::bench
