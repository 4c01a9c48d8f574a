#include "space/cost_to_go.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "space/lower_bound.hpp"

namespace alate {

namespace {

constexpr int kLayers = CoarseBand::kLayers;
constexpr int kDirections = 8;
/// Neighbours counter-clockwise from east; even ones are straight, odd ones diagonal.
constexpr std::array<int, kDirections> kColumn{1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, kDirections> kRow{0, 1, 1, 1, 0, -1, -1, -1};
/// Cells this near to the goal take the straight estimate.
constexpr double kSeedCells = 1.5;
/// Improvements below this part of one cell's cost are not passed on.
constexpr double kWorthwhile = 1e-3;
constexpr std::size_t kPollEvery = 256;

std::size_t at(std::size_t cell, int layer) { return cell * kLayers + static_cast<std::size_t>(layer); }

std::size_t offer_at(std::size_t cell, int direction, int layer) {
  return (cell * kDirections + static_cast<std::size_t>(direction)) * kLayers + static_cast<std::size_t>(layer);
}

double slope(const std::optional<double>& limit_rad) {
  return limit_rad && *limit_rad < kPi / 2 ? std::tan(*limit_rad) : kInfinity;
}

}  // namespace

CostToGo::CostToGo(const World& world, RunContext& run)
    : site_(world.site()),
      band_(world, run),
      climb_slope_(slope(site_.vehicle.climb_rad)),
      descent_slope_(slope(site_.vehicle.descent_rad)),
      values_(band_.size() * kLayers, kInfinity),
      offers_(band_.size() * kDirections * kLayers, std::numeric_limits<float>::infinity()),
      queued_(band_.size(), 0) {
  Queue queue;
  seed(queue);
  for (std::size_t pops = 1; !queue.empty(); ++pops) {
    if (pops % kPollEvery == 0 && !run.keep_going()) break;
    const std::size_t cell = queue.top().cell;
    queue.pop();
    if (queued_[cell] == 0) continue;
    queued_[cell] = 0;
    relax_around(cell, queue);
  }
}

void CostToGo::seed(Queue& queue) {
  const double radius = std::max(site_.mission.tolerance_m, kSeedCells * band_.cell_m());
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    const Vec2 center = band_.center(cell);
    if (band_.blocked(cell) || (center - site_.mission.goal.head<2>()).norm() > radius) continue;
    for (int layer = 0; layer < kLayers; ++layer)
      if (band_.threat(cell, layer) < kInfinity)
        values_[at(cell, layer)] = straight_estimate({center.x(), center.y(), band_.altitude(cell, layer)});
    queued_[cell] = 1;
    queue.push({lowest(cell), cell});
  }
}

void CostToGo::relax_around(std::size_t from, Queue& queue) {
  const int columns = band_.columns();
  const int column = static_cast<int>(from) % columns;
  const int row = static_cast<int>(from) / columns;
  for (int direction = 0; direction < kDirections; ++direction) {
    // `direction` is the way flown, from the neighbour behind to `from`.
    const int c = column - kColumn[static_cast<std::size_t>(direction)];
    const int r = row - kRow[static_cast<std::size_t>(direction)];
    if (c < 0 || r < 0 || c >= columns || r >= band_.rows()) continue;
    const std::size_t cell =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
    if (band_.blocked(cell) || !relax(cell, direction, from)) continue;
    queued_[cell] = 1;
    queue.push({lowest(cell), cell});
  }
}

bool CostToGo::relax(std::size_t cell, int direction, std::size_t from) {
  const double distance = band_.cell_m() * (direction % 2 == 0 ? 1.0 : std::numbers::sqrt2);
  bool improved = false;
  for (int layer = 0; layer < kLayers; ++layer) {
    if (band_.threat(cell, layer) == kInfinity) continue;
    const double offer = reach(from, distance, band_.altitude(cell, layer));
    float& known = offers_[offer_at(cell, direction, layer)];
    if (!(static_cast<float>(offer) < known)) continue;
    known = static_cast<float>(offer);
    improved |= improve(cell, direction, layer);
  }
  if (improved) circle(cell);
  return improved;
}

/// Altitude can be changed within a cell, on circles as long as the slope limits ask for.
void CostToGo::circle(std::size_t cell) {
  const double layer_m = band_.layer_m(cell);
  const double climb = site_.scenario.objective.climb * layer_m;
  const auto value = [&](int layer) -> double& { return values_[at(cell, layer)]; };
  for (int layer = kLayers - 2; layer >= 0; --layer)
    value(layer) = std::min(value(layer), value(layer + 1) + climb + metre_cost(cell, layer) * layer_m / climb_slope_);
  for (int layer = 1; layer < kLayers; ++layer)
    value(layer) = std::min(value(layer), value(layer - 1) + metre_cost(cell, layer) * layer_m / descent_slope_);
}

double CostToGo::metre_cost(std::size_t cell, int layer) const {
  const ObjectiveSpec& weights = site_.scenario.objective;
  const double threat = band_.threat(cell, layer);
  return threat < kInfinity ? weights.length + weights.threat * threat : kInfinity;
}

/// The least that neighbour `from` costs for an aircraft that comes from altitude `z`, its climb included. The value
/// is linear between samples, so the minimum is at a sample, at `z` or at an end of what can be reached.
double CostToGo::reach(std::size_t from, double distance_m, double z) const {
  const double floor = band_.floor_m(from);
  const double layer_m = band_.layer_m(from);
  const double low = std::max(z - descent_slope_ * distance_m, floor);
  const double high = std::min(z + climb_slope_ * distance_m, floor + layer_m * (kLayers - 1));
  if (low > high) return kInfinity;
  const double climb = site_.scenario.objective.climb;
  const auto price = [&](double to) { return value_at(from, to) + climb * std::max(0.0, to - z); };
  double best = std::min({price(low), price(high), price(std::clamp(z, low, high))});
  if (layer_m <= 0) return best;
  const int first = static_cast<int>(std::ceil((low - floor) / layer_m));
  const int last = static_cast<int>(std::floor((high - floor) / layer_m));
  for (int layer = first; layer <= std::min(last, kLayers - 1); ++layer)
    best = std::min(best, values_[at(from, layer)] + climb * std::max(0.0, band_.altitude(from, layer) - z));
  return best;
}

bool CostToGo::improve(std::size_t cell, int direction, int layer) {
  const double step = band_.cell_m() * metre_cost(cell, layer);
  const auto offer = [&](int d) {
    return static_cast<double>(offers_[offer_at(cell, (d + kDirections) % kDirections, layer)]);
  };
  const bool is_straight = direction % 2 == 0;
  double best = offer(direction) + step * (is_straight ? 1.0 : std::numbers::sqrt2);
  for (const int side : {-1, 1}) {
    const double straight = offer(is_straight ? direction : direction + side);
    const double diagonal = offer(is_straight ? direction + side : direction);
    const double gain = straight - diagonal;
    if (gain > 0 && gain < step * std::numbers::sqrt2 / 2)
      best = std::min(best, straight + std::sqrt(step * step - gain * gain));
  }
  double& value = values_[at(cell, layer)];
  if (!(best < value - kWorthwhile * step)) return false;
  value = best;
  return true;
}

double CostToGo::straight_estimate(const Vec3& position) const { return physical_bound(site_, position); }

double CostToGo::value_at(std::size_t cell, double z) const {
  const double layer_m = band_.layer_m(cell);
  if (layer_m <= 0) return values_[at(cell, 0)];
  const double position = std::clamp((z - band_.floor_m(cell)) / layer_m, 0.0, kLayers - 1.0);
  const int below = std::min(static_cast<int>(position), kLayers - 2);
  const double part = position - below;
  if (part <= 0) return values_[at(cell, below)];
  if (part >= 1) return values_[at(cell, below + 1)];
  return (1 - part) * values_[at(cell, below)] + part * values_[at(cell, below + 1)];
}

double CostToGo::lowest(std::size_t cell) const {
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(at(cell, 0));
  return *std::min_element(first, first + kLayers);
}

double CostToGo::operator()(const Vec3& position) const {
  if ((position - site_.mission.goal).head<2>().norm() < kSeedCells * band_.cell_m())
    return straight_estimate(position);
  return band_.blend(position.head<2>(), [&](std::size_t cell) { return value_at(cell, position.z()); });
}

Vec2 CostToGo::nearest_reached(const Vec2& xy) const {
  Vec2 best = site_.mission.goal.head<2>();
  double best_m = (best - xy).norm();
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    const double distance = (band_.center(cell) - xy).norm();
    if (lowest(cell) < kInfinity && distance < best_m) {
      best = band_.center(cell);
      best_m = distance;
    }
  }
  return best;
}

}  // namespace alate
