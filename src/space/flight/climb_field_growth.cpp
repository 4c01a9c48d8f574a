// How far a field has grown, and what of it outlives a new threat.
#include <algorithm>

#include "space/flight/climb_field.hpp"

namespace alate {

/// `enough` is asked now and then whether all values below the one given are enough.
template <class Enough>
void ClimbField::grow_until(RunContext& run, const Enough& enough) {
  constexpr std::size_t kPollEvery = 1024;
  for (std::size_t pops = 1; !queue_.empty(); ++pops) {
    if (pops % kPollEvery == 0 && (!run.keep_going() || enough(double{queue_.top().value}))) break;
    const Queued top = queue_.top();
    queue_.pop();
    if (top.value == waiting_[top.cell]) settle(top.cell);
  }
}

void ClimbField::grow(RunContext& run, const std::optional<Vec3>& until) {
  // A search looks a little behind it, too.
  constexpr double kCellsBeyond = 2;
  const double margin = kCellsBeyond * band_.cell_m() * site_->scenario.objective.length;
  grow_until(run, [&](double reached) { return until && reached > (*this)(*until) + margin; });
}

void ClimbField::grow_to(RunContext& run, double cost) {
  grow_until(run, [&](double reached) { return reached > cost; });
}

void ClimbField::add_threats(const World& world, std::span<const Threat> added) {
  site_ = &world.site();
  float least = std::numeric_limits<float>::infinity();
  for (const Threat& threat : added)
    band_.add_threat(world, threat, [&](std::size_t cell) {
      set_metre_cost(cell);
      const auto first = values_.begin() + static_cast<std::ptrdiff_t>(cell * kLayers);
      least = std::min(least, *std::min_element(first, first + kLayers));
    });
  if (least == std::numeric_limits<float>::infinity()) return;
  forget_from(least);
  seed();
}

void ClimbField::aim_anew() {
  end_ = site_->mission.goal;
  tolerance_m_ = site_->mission.tolerance_m;
  forget();
  seed();
}

void ClimbField::forget() {
  std::ranges::fill(values_, std::numeric_limits<float>::infinity());
  queue_ = {};
  std::ranges::fill(waiting_, std::numeric_limits<float>::infinity());
  std::ranges::fill(fresh_, std::uint8_t{0});
}

void ClimbField::confine(const Vec2& center, double radius_m) {
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    if ((band_.center(cell) - center).squaredNorm() <= radius_m * radius_m) continue;
    const auto first = metre_cost_.begin() + static_cast<std::ptrdiff_t>(cell * kLayers);
    std::fill(first, first + kLayers, std::numeric_limits<float>::infinity());
  }
}

/// A way of a sample that costs less does not lead through a cell that has changed.
void ClimbField::forget_from(float least) {
  for (float& value : values_)
    if (value >= least) value = std::numeric_limits<float>::infinity();
  queue_ = {};
  std::ranges::fill(waiting_, std::numeric_limits<float>::infinity());
  std::ranges::fill(fresh_, std::uint8_t{0});
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    if (band_.blocked(cell) || !borders_forgotten(cell)) continue;
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(cell * kLayers);
    const float cheapest = *std::min_element(first, first + kLayers);
    if (cheapest < least) {
      fresh_[cell] = (1U << kLayers) - 1;
      enqueue(cell, cheapest);
    }
  }
}

bool ClimbField::borders_forgotten(std::size_t cell) const {
  const auto any_forgotten = [&](std::size_t at) {
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(at * kLayers);
    return std::any_of(first, first + kLayers, [](float value) { return std::isinf(value); });
  };
  if (any_forgotten(cell)) return true;
  const int columns = band_.columns();
  const int column = static_cast<int>(cell) % columns;
  const int row = static_cast<int>(cell) / columns;
  return std::ranges::any_of(steps_, [&](const Step& step) {
    const int c = column + step.column;
    const int r = row + step.row;
    if (c < 0 || r < 0 || c >= columns || r >= band_.rows()) return false;
    const auto at = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c);
    return !band_.blocked(at) && any_forgotten(at);
  });
}

}  // namespace alate
