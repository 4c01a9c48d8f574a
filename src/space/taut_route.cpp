#include "space/taut_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "space/sure_leg.hpp"

namespace alate {

namespace {

double length(const std::vector<Vec3>& places) {
  double sum = 0;
  for (std::size_t i = 1; i < places.size(); ++i) sum += (places[i] - places[i - 1]).norm();
  return sum;
}

/// By how much a cost has to fall to count: rounding must not keep a search going.
constexpr double kLeastGain = 1e-9;

}  // namespace

TautRoute::TautRoute(const World& world)
    : world_(world),
      objective_(world),
      limits_(world.site()),
      range_m_(world.site().vehicle.range_m.value_or(kInfinity)) {}

double TautRoute::cost(const std::vector<Vec3>& places) const {
  double sum = 0;
  for (std::size_t i = 1; i < places.size(); ++i) sum += objective_.leg_cost({places[i - 1], places[i]});
  return sum;
}

double TautRoute::leg_cost(const Vec3& from, const Vec3& to) const {
  const bool may_fly = limits_.allows(to - from) && is_surely_free(world_, {from, to});
  return may_fly ? objective_.leg_cost({from, to}) : kInfinity;
}

/// Does the corner at this place have room, or does the first leg suit the heading at the start?
bool TautRoute::fits(const Places& places, std::size_t corner) const {
  if (corner + 1 >= places.size()) return true;
  const Vec3 after = places[corner + 1] - places[corner];
  return corner == 0 ? limits_.allows_first(after) : limits_.allows_corner(places[corner] - places[corner - 1], after);
}

bool TautRoute::keeps_range(const Places& places) const { return range_m_ == kInfinity || length(places) <= range_m_; }

std::vector<Vec3> TautRoute::pull(std::vector<Vec3> places, double step_m, RunContext& run) const {
  constexpr std::array kHalvings{2.0, 1.0, 0.5, 0.25};  // of `step_m`, for legs
  places = drop(places, run);
  for (const double share : kHalvings) {
    if (!run.keep_going()) break;
    places = halve(places, 4 * share * step_m);
    relax(places, share * step_m, run);
    places = drop(places, run);
  }
  return places;
}

std::vector<double> TautRoute::all_legs(const Places& places, RunContext& run) const {
  const std::size_t count = places.size();
  std::vector<double> legs(count * count, kInfinity);
  run.executor().for_ranges(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = i + 1; j < count && run.keep_going(); ++j)
        legs[i * count + j] = leg_cost(places[i], places[j]);
  });
  return legs;
}

/// The cheapest way over some of the places in order, by the last leg.
std::vector<Vec3> TautRoute::drop(const Places& places, RunContext& run) const {
  const std::size_t count = places.size();
  const std::vector<double> legs = all_legs(places, run);
  std::vector<Way> ways(count * count);  // that end in a leg from, to
  for (std::size_t j = 1; j < count; ++j)
    if (limits_.allows_first(places[j] - places[0])) ways[j].cost = legs[j];
  for (std::size_t i = 1; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (legs[i * count + j] < kInfinity) ways[i * count + j] = way_over(places, ways, {i, j}, legs[i * count + j]);
  std::size_t to = count - 1;
  std::size_t from = 0;
  for (std::size_t i = 1; i < to; ++i)
    if (ways[i * count + to].cost < ways[from * count + to].cost) from = i;
  if (!(ways[from * count + to].cost <= cost(places)) || !run.keep_going()) return places;
  Places left{places[to]};
  while (to != 0) {
    left.push_back(places[from]);
    to = std::exchange(from, ways[from * count + to].before);
  }
  std::ranges::reverse(left);
  return keeps_range(left) ? left : places;
}

/// The cheapest of the ways that end in a leg, which itself costs so much.
TautRoute::Way TautRoute::way_over(const Places& places, const std::vector<Way>& ways, std::array<std::size_t, 2> leg,
                                   double leg_cost) const {
  const auto [from, to] = leg;
  const std::size_t count = places.size();
  Way best;
  for (std::size_t before = 0; before < from; ++before) {
    const double sum = ways[before * count + from].cost + leg_cost;
    if (sum < best.cost && limits_.allows_corner(places[from] - places[before], places[to] - places[from]))
      best = {.cost = sum, .before = before};
  }
  return best;
}

/// Legs in equal pieces no longer than that, where those are free, too (what bounds a leg's clearance may bound that of
/// a piece less well).
std::vector<Vec3> TautRoute::halve(const Places& places, double longest_m) const {
  constexpr double kMostPlaces = 60;
  longest_m = std::max(longest_m, length(places) / kMostPlaces);
  Places all{places.front()};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Vec3 leg = places[i] - places[i - 1];
    const double pieces = std::max(1.0, std::ceil(leg.norm() / longest_m));
    const std::size_t whole = all.size();
    for (double piece = 1; piece < pieces; ++piece) all.emplace_back(places[i - 1] + leg * (piece / pieces));
    all.push_back(places[i]);
    for (std::size_t k = whole; k < all.size(); ++k) {
      if (leg_cost(all[k - 1], all[k]) < kInfinity) continue;
      all.resize(whole);
      all.push_back(places[i]);
      break;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!fits(all, i)) return places;
  return all;
}

void TautRoute::relax(Places& places, double step_m, RunContext& run) const {
  constexpr int kScales = 10;
  constexpr int kSweeps = 6;
  for (int scale = 0; scale < kScales; ++scale, step_m /= 2) {
    bool moved = true;
    for (int sweep = 0; sweep < kSweeps && moved; ++sweep) {
      moved = false;
      for (std::size_t i = 1; i + 1 < places.size() && run.keep_going(); ++i) moved = shift(places, i, step_m) || moved;
    }
  }
}

/// Aside, up and down, and both at once.
bool TautRoute::shift(Places& places, std::size_t i, double step_m) const {
  constexpr double kUp = 0.25;  // ground is seldom steeper than that
  const Vec3 along = places[i + 1] - places[i - 1];
  const Vec3 aside = step_m * Vec3(-along.y(), along.x(), 0).normalized();
  const Vec3 up(0, 0, kUp * step_m);
  double best = objective_.leg_cost({places[i - 1], places[i]}) + objective_.leg_cost({places[i], places[i + 1]});
  bool moved = false;
  for (const Vec3& way : {Vec3(-up), Vec3(aside), Vec3(-aside), Vec3(aside - up), Vec3(-aside - up), Vec3(aside + up),
                          Vec3(-aside + up), up})
    moved = try_place(places, i, places[i] + way, best) || moved;
  return moved;
}

bool TautRoute::try_place(Places& places, std::size_t i, const Vec3& place, double& best) const {
  const double first = objective_.leg_cost({places[i - 1], place});
  const double second = objective_.leg_cost({place, places[i + 1]});
  if (!(first + second < best * (1 - kLeastGain))) return false;
  if (!(leg_cost(places[i - 1], place) + leg_cost(place, places[i + 1]) < kInfinity)) return false;
  const Vec3 old = std::exchange(places[i], place);
  if (fits(places, i - 1) && fits(places, i) && fits(places, i + 1) && keeps_range(places)) {
    best = first + second;
    return true;
  }
  places[i] = old;
  return false;
}

}  // namespace alate
