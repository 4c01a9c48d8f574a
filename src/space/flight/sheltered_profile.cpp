#include "space/flight/sheltered_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr std::size_t kLevels = 24;
/// Half of a lane: room to fly straight instead of from station to station.
constexpr double kLane_m = 2;

/// Floor and ceiling of the tube at a distance, straight between gates.
Gate gate_at(const std::vector<Gate>& tube, double at_m) {
  const auto after = std::ranges::upper_bound(tube, at_m, {}, &Gate::at_m);
  if (after == tube.begin()) return tube.front();
  if (after == tube.end()) return tube.back();
  const Gate& a = *(after - 1);
  const Gate& b = *after;
  const double part = (at_m - a.at_m) / (b.at_m - a.at_m);
  return {at_m, a.floor + part * (b.floor - a.floor), a.ceiling + part * (b.ceiling - a.ceiling)};
}

struct Station {
  explicit Station(const Gate& at) : gate(at) {
    for (std::size_t j = 0; j < kLevels; ++j)
      levels[j] = gate.floor + (gate.ceiling - gate.floor) * static_cast<double>(j) / (kLevels - 1);
  }

  Gate gate;
  std::array<double, kLevels> levels{};
  std::array<double, kLevels> to_go{};

  double to_go_from(double z) const {
    const double height = gate.ceiling - gate.floor;
    if (!(height > 0)) return to_go[0];
    const double position = std::clamp((z - gate.floor) / height, 0.0, 1.0) * (kLevels - 1);
    const auto below = std::min(static_cast<std::size_t>(position), kLevels - 2);
    const double part = position - static_cast<double>(below);
    return (1 - part) * to_go[below] + part * to_go[below + 1];
  }
};

class Programme {
 public:
  Programme(const std::vector<Gate>& tube, double step_m, const SlopeLimits& slopes, const ProfilePrices& prices)
      : slopes_(slopes), prices_(prices) {
    const double length = tube.back().at_m;
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length / step_m)));
    for (std::size_t i = 0; i <= count; ++i)
      stations_.emplace_back(gate_at(tube, length * static_cast<double>(i) / static_cast<double>(count)));
    for (std::size_t i = count; i-- > 0;) {
      Station& station = stations_[i];
      prices_.exposure(station.gate.at_m, stations_[i + 1].gate.at_m, station.levels, station.to_go);
      for (std::size_t j = 0; j < kLevels; ++j) station.to_go[j] += next(i, station.levels[j]).cost;
    }
  }

  /// From the only altitude of the first station.
  std::vector<ProfilePoint> cheapest() const {
    std::vector<ProfilePoint> points{{stations_.front().gate.at_m, stations_.front().gate.floor}};
    for (std::size_t i = 0; i + 1 < stations_.size(); ++i)
      points.push_back({stations_[i + 1].gate.at_m, next(i, points.back().z).z});
    return points;
  }

 private:
  struct Choice {
    double z = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  /// The altitude at the station after i that is best for who is at z now, exposure up to there apart.
  Choice next(std::size_t i, double z) const {
    const Station& to = stations_[i + 1];
    const double ahead = to.gate.at_m - stations_[i].gate.at_m;
    const double low = std::clamp(z - ahead * slopes_.descent, to.gate.floor, to.gate.ceiling);
    const double high = std::clamp(z + ahead * slopes_.climb, low, to.gate.ceiling);
    Choice best;
    const auto consider = [&](double at, double to_go) {
      const double rest = prices_.climb * std::max(0.0, at - z) + to_go;
      if (prices_.length * ahead + rest >= best.cost) return;  // no root is needed to see that
      const double cost = prices_.length * std::sqrt(ahead * ahead + (at - z) * (at - z)) + rest;
      if (cost < best.cost) best = {at, cost};
    };
    for (const double at : {std::clamp(z, low, high), low, high}) consider(at, to.to_go_from(at));
    for (std::size_t j = 0; j < kLevels; ++j)
      if (const double at = to.levels[j]; at > low && at < high) consider(at, to.to_go[j]);
    return best;
  }

  SlopeLimits slopes_;
  const ProfilePrices& prices_;
  std::vector<Station> stations_;
};

}  // namespace

std::vector<Gate> tube_of(std::vector<Gate> gates, double z_from, const SlopeLimits& slopes) {
  gates.front().floor = gates.front().ceiling = z_from;
  for (std::size_t i = 1; i < gates.size(); ++i) {
    const double ahead = gates[i].at_m - gates[i - 1].at_m;
    gates[i].floor = std::max(gates[i].floor, gates[i - 1].floor - ahead * slopes.descent);
    gates[i].ceiling = std::min(gates[i].ceiling, gates[i - 1].ceiling + ahead * slopes.climb);
  }
  for (std::size_t i = gates.size() - 1; i-- > 0;) {
    const double ahead = gates[i + 1].at_m - gates[i].at_m;
    gates[i].floor = std::max(gates[i].floor, gates[i + 1].floor - ahead * slopes.climb);
    gates[i].ceiling = std::min(gates[i].ceiling, gates[i + 1].ceiling + ahead * slopes.descent);
  }
  const bool open = std::ranges::all_of(gates, [](const Gate& gate) { return gate.floor <= gate.ceiling; });
  return open ? gates : std::vector<Gate>{};
}

std::vector<Gate> sheltered_lane(const std::vector<Gate>& tube, double step_m, const SlopeLimits& slopes,
                                 const ProfilePrices& prices) {
  const std::vector<ProfilePoint> cheapest = Programme(tube, step_m, slopes, prices).cheapest();
  std::vector<Gate> lane = tube;
  for (Gate& gate : lane) {
    const double z = std::clamp(altitude_at(cheapest, gate.at_m), gate.floor, gate.ceiling);
    gate.floor = std::max(gate.floor, z - kLane_m);
    gate.ceiling = std::min(gate.ceiling, z + kLane_m);
  }
  return lane;
}

}  // namespace alate
