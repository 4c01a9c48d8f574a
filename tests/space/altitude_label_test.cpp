// Labels against every altitude there is: floors, ceilings and slopes in whole metres, so that a table of whole
// altitudes is exact.
#include "space/flight/altitude_label.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

constexpr double kPiece_m = 10;
constexpr int kUp = 3;  // metres a piece
constexpr int kDown = 2;
const SlopeLimits kSlopes{.climb = 0.3, .descent = 0.2};

struct Knot {
  int floor = 0;
  int ceiling = 0;
};

std::vector<Knot> draw_band(Stream& random, int room) {
  std::vector<Knot> knots;
  int floor = 0;
  for (int k = 0; k < 25; ++k) {
    floor += static_cast<int>(random.below(11)) - 5;
    knots.push_back({floor, floor + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(room)))});
  }
  return knots;
}

/// Least ascent by altitude, of all flights through the knots from the first one.
std::map<int, int> all_flights(const std::vector<Knot>& knots, int z, int up, int down) {
  std::map<int, int> reached;
  if (z >= knots[0].floor && z <= knots[0].ceiling) reached[z] = 0;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    std::map<int, int> next;
    for (const auto& [from, ascent] : reached)
      for (int to = std::max(from - down, knots[k].floor); to <= std::min(from + up, knots[k].ceiling); ++to) {
        const int all = ascent + std::max(0, to - from);
        const auto [known, is_new] = next.emplace(to, all);
        if (!is_new) known->second = std::min(known->second, all);
      }
    reached = std::move(next);
  }
  return reached;
}

template <class Label>
bool pass(const std::vector<Knot>& knots, Label& label, std::size_t from, std::size_t to) {
  for (std::size_t k = from;; k = from < to ? k + 1 : k - 1) {
    label.clip(knots[k].floor, knots[k].ceiling);
    if (!label.alive()) return false;
    if (k == to) return true;
    label.advance(kPiece_m, kSlopes);
  }
}

TEST(AltitudeLabel, HoldsExactlyTheAltitudesThatFlightsReach) {
  int alive = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Stream random(seed, 0, 0);
    const std::vector<Knot> knots = draw_band(random, 16);
    const int z = knots[0].floor + 1;
    const auto flights = all_flights(knots, z, kUp, kDown);
    AltitudeLabel label = AltitudeLabel::at(z);
    ASSERT_EQ(pass(knots, label, 0, knots.size() - 1), !flights.empty()) << seed;
    if (flights.empty()) continue;
    ++alive;
    EXPECT_NEAR(label.low, flights.begin()->first, 1e-9) << seed;
    EXPECT_NEAR(label.high, flights.rbegin()->first, 1e-9) << seed;
    for (const auto& [altitude, ascent] : flights) EXPECT_NEAR(label.ascent_to(altitude), ascent, 1e-9) << seed;
  }
  EXPECT_GT(alive, 100);
  EXPECT_LT(alive, 400);
}

/// A flight cut in two anywhere: what both halves know together is what the whole one costs.
TEST(AltitudeLabel, MeetsTheLabelFromTheGoal) {
  int met = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Stream random(seed, 1, 0);
    const std::vector<Knot> knots = draw_band(random, 20);
    const int start = knots.front().floor + 1;
    const int goal = knots.back().floor;
    const auto flights = all_flights(knots, start, kUp, kDown);
    const auto whole = flights.find(goal);
    const std::size_t cut = random.below(knots.size());
    AltitudeLabel forward = AltitudeLabel::at(start);
    BackwardLabel backward{.low = static_cast<double>(goal),
                           .high = static_cast<double>(goal),
                           .ascent = 0,
                           .free = static_cast<double>(goal)};
    const bool alive = pass(knots, forward, 0, cut) && pass(knots, backward, knots.size() - 1, cut);
    const auto meeting = alive ? meet(forward, backward) : std::nullopt;
    ASSERT_EQ(meeting.has_value(), whole != flights.end()) << seed;
    if (!meeting) continue;
    ++met;
    EXPECT_NEAR(meeting->ascent, whole->second, 1e-9) << seed;
    EXPECT_NEAR(forward.ascent_to(meeting->z) + backward.ascent_from(meeting->z), meeting->ascent, 1e-12);
  }
  EXPECT_GT(met, 50);
}

}  // namespace
}  // namespace alate
