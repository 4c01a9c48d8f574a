#include "search/interval/flight_pool.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace alate {

namespace {

/// Places at equal parts of a track.
std::vector<Vec2> places_along(const Track& track) {
  constexpr int kPlaces = 32;
  const double step_m = length_of(track) / kPlaces;
  std::vector<Vec2> places;
  double begin = 0;
  for (const PlanarPiece& piece : track) {
    while (static_cast<double>(places.size()) * step_m < begin + piece.length_m)
      places.push_back(piece.at(static_cast<double>(places.size()) * step_m - begin).position());
    begin += piece.length_m;
  }
  places.resize(kPlaces, places.empty() ? Vec2::Zero() : places.back());
  return places;
}

}  // namespace

bool FlightPool::alike(const Track& a, const Track& b) const {
  const auto near = [&](const Vec2& p, const Vec2& q) { return (p - q).norm() < apart_m_; };
  return std::ranges::equal(places_along(a), places_along(b), near);
}

void FlightPool::sort() { std::ranges::stable_sort(paths_, std::less{}, &FlightPath::cost); }

void FlightPool::add_bettered(FlightPath path, Stream& random, RunContext& run) {
  path.shorten(run);
  path.better(random, trials_, run);
  add(std::move(path));
}

void FlightPool::add(FlightPath path) {
  if (!std::isfinite(path.cost())) return;
  const Track track = path.track();
  const auto twin = std::ranges::find_if(paths_, [&](const FlightPath& one) { return alike(one.track(), track); });
  if (twin == paths_.end())
    paths_.push_back(std::move(path));
  else if (path.cost() < twin->cost())
    *twin = std::move(path);
  sort();
  if (paths_.size() > kMost) paths_.pop_back();
}

void FlightPool::better(Stream& random, RunContext& run) {
  if (paths_.empty()) return;
  const auto rank = static_cast<std::size_t>(std::countr_zero(++rounds_));
  paths_[std::min(rank, paths_.size() - 1)].better(random, trials_, run);
  sort();
}

}  // namespace alate
