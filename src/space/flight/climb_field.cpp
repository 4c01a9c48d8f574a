#include "space/flight/climb_field.hpp"

#include <algorithm>
#include <cmath>

#include "space/lower_bound.hpp"

namespace alate {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
/// Cells this near to the goal take the straight estimate.
constexpr double kSeedCells = 1.5;
/// Improvements below this part of a cell's cost are not passed on.
constexpr float kWorthwhile = 0.005F;
constexpr std::size_t kPollEvery = 1024;
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

}  // namespace

ClimbField::ClimbField(const World& world, const SlopeLimits& slopes, RunContext& run, const std::optional<Vec3>& until)
    : site_(&world.site()),
      slopes_(slopes),
      band_(world, run),
      climb_weight_(static_cast<float>(site_->scenario.objective.climb)),
      values_(band_.size() * kLayers, kNever),
      metre_cost_(band_.size() * kLayers, kNever) {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double length = band_.cell_m() * std::hypot(kNeighbours[i][0], kNeighbours[i][1]);
    steps_[i] = {.column = kNeighbours[i][0],
                 .row = kNeighbours[i][1],
                 .length_m = static_cast<float>(length),
                 .climb_m = static_cast<float>(slopes.climb * length),
                 .descent_m = static_cast<float>(slopes.descent * length)};
  }
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    floor_.push_back(static_cast<float>(band_.floor_m(cell)));
    layer_m_.push_back(static_cast<float>(band_.layer_m(cell)));
    if (!band_.blocked(cell)) set_metre_cost(cell);
  }
  seed();
  grow(run, until);
}

void ClimbField::set_metre_cost(std::size_t cell) {
  const ObjectiveSpec& weights = site_->scenario.objective;
  for (int layer = 0; layer < kLayers; ++layer)
    metre_cost_[cell * kLayers + static_cast<std::size_t>(layer)] =
        static_cast<float>(weights.length + weights.threat * band_.threat(cell, layer));
}

void ClimbField::grow(RunContext& run, const std::optional<Vec3>& until) {
  for (std::size_t pops = 1; !queue_.empty(); ++pops) {
    if (pops % kPollEvery == 0 && (!run.keep_going() || is_known(until, queue_.top().value))) break;
    const Queued top = queue_.top();
    queue_.pop();
    if (top.value == values_[top.sample]) settle(top.sample);
  }
}

void ClimbField::seed() {
  const double radius = std::max(site_->mission.tolerance_m, kSeedCells * band_.cell_m());
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    const Vec2 center = band_.center(cell);
    if (band_.blocked(cell) || (center - site_->mission.goal.head<2>()).norm() > radius) continue;
    for (int layer = 0; layer < kLayers; ++layer)
      if (metre_cost(cell, layer) < kNever)
        offer(cell, layer,
              static_cast<float>(physical_bound(*site_, {center.x(), center.y(), band_.altitude(cell, layer)})));
  }
}

void ClimbField::offer(std::size_t cell, int layer, float value) {
  const std::size_t sample = cell * kLayers + static_cast<std::size_t>(layer);
  const float worthwhile = kWorthwhile * static_cast<float>(band_.cell_m());
  if (!(value + worthwhile < values_[sample])) return;
  values_[sample] = value;
  queue_.push({value, static_cast<std::uint32_t>(sample)});
}

void ClimbField::settle(std::uint32_t sample) {
  const std::size_t cell = sample / kLayers;
  const int layer = static_cast<int>(sample % kLayers);
  circle(cell, layer);
  const int columns = band_.columns();
  const int column = static_cast<int>(cell) % columns;
  const int row = static_cast<int>(cell) / columns;
  for (const Step& step : steps_) {
    const int c = column + step.column;
    const int r = row + step.row;
    if (c < 0 || r < 0 || c >= columns || r >= band_.rows()) continue;
    const std::size_t from =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
    if (!band_.blocked(from)) relax(from, step, cell, layer);
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

/// Samples of a cell from which the aircraft can reach altitudes near a sample of `to` that has become cheaper. The
/// value is linear between samples, so the best altitude is a sample, the one flown so far, or the last within reach.
void ClimbField::relax(std::size_t cell, const Step& step, std::size_t to, int layer) {
  const float here = floor_[to] + layer_m_[to] * static_cast<float>(layer);
  const float low = here - layer_m_[to];
  const float high = here + layer_m_[to];
  const float spacing = layer_m_[cell];
  const float* near = &values_[to * kLayers + static_cast<std::size_t>(layer)];
  const float cheapest = std::min({near[0], layer > 0 ? near[-1] : kNever, layer + 1 < kLayers ? near[1] : kNever});
  const float bottom = floor_[to];
  const float top = floor_[to] + layer_m_[to] * (kLayers - 1);
  for (int from = 0; from < kLayers; ++from) {
    const float z = floor_[cell] + spacing * static_cast<float>(from);
    const float least = std::max(z - step.descent_m, bottom);
    const float most = std::min(z + step.climb_m, top);
    if (least > high) break;
    if (most < low || least > most) continue;
    const float metre = metre_cost(cell, from);
    if (!(metre * step.length_m + cheapest < values_[cell * kLayers + static_cast<std::size_t>(from)])) continue;
    const auto price = [&](float at) { return value_at(to, at) + climb_weight_ * std::max(0.0F, at - z); };
    const float best = std::min(price(std::clamp(here, least, most)), price(std::clamp(z, least, most)));
    offer(cell, from, metre * step.length_m + best);
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
  if ((position - site_->mission.goal).head<2>().norm() < kSeedCells * band_.cell_m())
    return physical_bound(*site_, position);
  return band_.blend(position.head<2>(),
                     [&](std::size_t cell) { return double{value_at(cell, static_cast<float>(position.z()))}; });
}

}  // namespace alate
