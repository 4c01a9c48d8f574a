#include "space/flight/climb_field.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
/// Cells this near to the goal take the straight estimate.
constexpr double kSeedCells = 1.5;
/// Improvements below this part of a cell's cost are not passed on.
constexpr float kWorthwhile = 0.03F;
/// Columns and rows of the sixteen neighbours.
constexpr std::array<std::array<int, 2>, 16> kNeighbours{{{1, 0},
                                                          {1, 1},
                                                          {0, 1},
                                                          {-1, 1},
                                                          {-1, 0},
                                                          {-1, -1},
                                                          {0, -1},
                                                          {1, -1},
                                                          {2, 1},
                                                          {1, 2},
                                                          {-1, 2},
                                                          {-2, 1},
                                                          {-2, -1},
                                                          {-1, -2},
                                                          {1, -2},
                                                          {2, -1}}};

/// Finer cells cost more time than they save: aircraft cannot turn within them, or there are more than enough on the
/// way.
double least_cell_m(const Site& site) {
  constexpr double kRadii = 1.25;
  constexpr double kOnTheWay = 80;
  const double distance = (site.mission.goal - site.mission.start).norm();
  return std::max(kRadii * site.vehicle.turn_radius_m.value_or(0), distance / kOnTheWay);
}

}  // namespace

ClimbField::ClimbField(const World& world, const SlopeLimits& slopes, RunContext& run, const std::optional<Vec3>& until)
    : site_(&world.site()),
      slopes_(slopes),
      end_(site_->mission.goal),
      tolerance_m_(site_->mission.tolerance_m),
      band_(world, run, least_cell_m(*site_)),
      climb_weight_(static_cast<float>(site_->scenario.objective.climb)),
      values_(band_.size() * kLayers, kNever),
      metre_cost_(band_.size() * kLayers, kNever),
      waiting_(band_.size(), kNever),
      fresh_(band_.size(), 0),
      worthwhile_(kWorthwhile * static_cast<float>(band_.cell_m())) {
  set_steps();
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    floor_.push_back(static_cast<float>(band_.floor_m(cell)));
    layer_m_.push_back(static_cast<float>(band_.layer_m(cell)));
    if (!band_.blocked(cell)) set_metre_cost(cell);
  }
  seed();
  grow(run, until);
}

ClimbField ClimbField::homeward() const {
  ClimbField home(*this);
  home.slopes_ = slopes_.reversed();
  home.end_ = site_->mission.start;
  home.tolerance_m_ = 0;
  home.set_steps();
  home.forget();
  home.seed();
  return home;
}

void ClimbField::set_steps() {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double length = band_.cell_m() * std::hypot(kNeighbours[i][0], kNeighbours[i][1]);
    steps_[i] = {.column = kNeighbours[i][0],
                 .row = kNeighbours[i][1],
                 .length_m = static_cast<float>(length),
                 .climb_m = static_cast<float>(slopes_.climb * length),
                 .descent_m = static_cast<float>(slopes_.descent * length)};
  }
}

/// What a straight flight costs, no shorter than the climb or descent that is needed allows.
double ClimbField::straight(const Vec3& from) const {
  const double rise = end_.z() - from.z();
  const double needed = std::max(0.0, std::abs(rise) - tolerance_m_);
  const double slope = rise > 0 ? slopes_.climb : slopes_.descent;
  const double length = std::max((end_ - from).norm() - tolerance_m_, needed * std::hypot(1, 1 / slope));
  return site_->scenario.objective.length * std::max(0.0, length) +
         (rise > 0 ? site_->scenario.objective.climb * needed : 0);
}

void ClimbField::set_metre_cost(std::size_t cell) {
  const ObjectiveSpec& weights = site_->scenario.objective;
  for (int layer = 0; layer < kLayers; ++layer)
    metre_cost_[cell * kLayers + static_cast<std::size_t>(layer)] =
        static_cast<float>(weights.length + weights.threat * band_.threat(cell, layer));
}

void ClimbField::seed() {
  const double radius = std::max(tolerance_m_, kSeedCells * band_.cell_m());
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    const Vec2 center = band_.center(cell);
    if (band_.blocked(cell) || (center - end_.head<2>()).norm() > radius) continue;
    for (int layer = 0; layer < kLayers; ++layer)
      if (metre_cost(cell, layer) < kNever)
        offer(cell, layer, static_cast<float>(straight({center.x(), center.y(), band_.altitude(cell, layer)})));
  }
}

void ClimbField::offer(std::size_t cell, int layer, float value) {
  float& known = values_[cell * kLayers + static_cast<std::size_t>(layer)];
  if (!(value + worthwhile_ < known)) return;
  known = value;
  fresh_[cell] |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(layer));
  enqueue(cell, value);
}

void ClimbField::enqueue(std::size_t cell, float value) {
  if (!(value < waiting_[cell])) return;
  waiting_[cell] = value;
  queue_.push({value, static_cast<std::uint32_t>(cell)});
}

/// Tells the neighbours of its fresh values.
void ClimbField::settle(std::size_t cell) {
  const float* values = &values_[cell * kLayers];
  const auto is_fresh = [&](int layer) { return (unsigned{fresh_[cell]} >> static_cast<unsigned>(layer) & 1U) != 0; };
  for (int layer = kLayers - 1; layer >= 0; --layer)
    if (is_fresh(layer)) circle(cell, layer);
  Fresh fresh{.low = kLayers, .high = 0, .cheapest = kNever};
  for (int layer = 0; layer < kLayers; ++layer) {
    if (!is_fresh(layer)) continue;
    fresh.low = std::min(fresh.low, layer);
    fresh.high = layer;
  }
  waiting_[cell] = kNever;
  fresh_[cell] = 0;
  fresh.low = std::max(fresh.low - 1, 0);
  fresh.high = std::min(fresh.high + 1, kLayers - 1);
  fresh.cheapest = *std::min_element(values + fresh.low, values + fresh.high + 1);
  const int columns = band_.columns();
  const int column = static_cast<int>(cell) % columns;
  const int row = static_cast<int>(cell) / columns;
  for (const Step& step : steps_) {
    const int c = column + step.column;
    const int r = row + step.row;
    if (c < 0 || r < 0 || c >= columns || r >= band_.rows()) continue;
    const std::size_t from =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
    if (!band_.blocked(from)) relax(from, step, cell, fresh);
  }
}

/// Altitude can be changed within a cell, on circles as long as the slope limits ask for.
void ClimbField::circle(std::size_t cell, int layer) {
  const float value = values_[cell * kLayers + static_cast<std::size_t>(layer)];
  const float layer_m = layer_m_[cell];
  if (layer > 0)
    offer(cell, layer - 1,
          value + climb_weight_ * layer_m + metre_cost(cell, layer - 1) * layer_m / static_cast<float>(slopes_.climb));
  if (layer + 1 < kLayers)
    offer(cell, layer + 1, value + metre_cost(cell, layer + 1) * layer_m / static_cast<float>(slopes_.descent));
}

/// The values of a cell, from which the aircraft flies to `to`, some of whose values have become cheaper. The value
/// there is linear between samples, so the best altitude is a sample, the one flown so far, or the last within reach.
void ClimbField::relax(std::size_t cell, const Step& step, std::size_t to, const Fresh& fresh) {
  const float bottom = floor_[to];
  const float spacing = layer_m_[to];
  const float per_metre = spacing > 0 ? 1 / spacing : 0;
  const float low = bottom + spacing * static_cast<float>(fresh.low);
  const float high = bottom + spacing * static_cast<float>(fresh.high);
  const float* there = &values_[to * kLayers];
  float* here = &values_[cell * kLayers];
  for (int layer = 0; layer < kLayers; ++layer) {
    const float z = floor_[cell] + layer_m_[cell] * static_cast<float>(layer);
    const float least = std::max(z - step.descent_m, low);
    const float most = std::min(z + step.climb_m, high);
    const float way = metre_cost(cell, layer) * step.length_m;
    if (least > most || !(way + fresh.cheapest < here[layer])) continue;
    float best = kNever;
    const auto look = [&](float value, float at) {
      // What is no number, between samples of which one is infinite, is never less.
      best = std::min(best, value + climb_weight_ * std::max(0.0F, at - z));
    };
    const auto look_between = [&](float at) {
      const float position = (at - bottom) * per_metre;
      const int below = std::min(static_cast<int>(position), kLayers - 2);
      look(there[below] + (position - static_cast<float>(below)) * (there[below + 1] - there[below]), at);
    };
    look_between(least);
    look_between(most);
    if (z > least && z < most) look_between(z);
    const int last = static_cast<int>((most - bottom) * per_metre);
    for (int k = static_cast<int>(std::ceil((least - bottom) * per_metre)); k <= last; ++k)
      look(there[k], bottom + spacing * static_cast<float>(k));
    offer(cell, layer, way + best);
  }
}

float ClimbField::value_at(std::size_t cell, float z) const {
  const float* values = &values_[cell * kLayers];
  if (layer_m_[cell] <= 0) return values[0];
  const float position = std::clamp((z - floor_[cell]) / layer_m_[cell], 0.0F, static_cast<float>(kLayers - 1));
  const int below = std::min(static_cast<int>(position), kLayers - 2);
  const float part = position - static_cast<float>(below);
  if (part <= 0) return values[below];
  if (part >= 1) return values[below + 1];
  return (1 - part) * values[below] + part * values[below + 1];
}

double ClimbField::operator()(const Vec3& position) const {
  if ((position - end_).head<2>().norm() < kSeedCells * band_.cell_m()) return straight(position);
  return band_.blend(position.head<2>(),
                     [&](std::size_t cell) { return double{value_at(cell, static_cast<float>(position.z()))}; });
}

}  // namespace alate
