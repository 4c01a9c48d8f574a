#include "space/flight/taut_string.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "space/flight/altitude_label.hpp"

namespace alate {
namespace {

double ascent_of(const std::vector<ProfilePoint>& profile) {
  double sum = 0;
  for (std::size_t i = 1; i < profile.size(); ++i) sum += std::max(0.0, profile[i].z - profile[i - 1].z);
  return sum;
}

double length_of(const std::vector<ProfilePoint>& profile) {
  double sum = 0;
  for (std::size_t i = 1; i < profile.size(); ++i)
    sum += std::hypot(profile[i].at_m - profile[i - 1].at_m, profile[i].z - profile[i - 1].z);
  return sum;
}

std::vector<Gate> draw_gates(Stream& random) {
  std::vector<Gate> gates;
  double at = 0;
  double floor = 0;
  for (int k = 0; k < 40; ++k) {
    gates.push_back({at, floor, floor + 2 + 15 * random.uniform()});
    at += 5 + 30 * random.uniform();
    floor += 12 * (random.uniform() - 0.5);
  }
  return gates;
}

TEST(TautString, IsStraightWhereNothingIsInTheWay) {
  const auto string = taut_string({{0, 0, 100}, {50, 0, 100}, {100, 0, 100}}, 10, 30);
  ASSERT_EQ(string.size(), 2U);
  EXPECT_DOUBLE_EQ(altitude_at(string, 25), 15);
}

TEST(TautString, BendsOverFloorsAndUnderCeilings) {
  const auto string = taut_string({{0, 0, 100}, {50, 40, 100}, {100, 0, 20}, {150, 0, 100}}, 0, 60);
  ASSERT_EQ(string.size(), 4U);
  EXPECT_DOUBLE_EQ(string[1].z, 40);
  EXPECT_DOUBLE_EQ(string[2].z, 20);
}

/// Whatever slopes a flight can keep, the string keeps; and no flight climbs less or is shorter.
TEST(TautString, IsTheBestOfAllProfiles) {
  const SlopeLimits slopes{.climb = 0.25, .descent = 0.4};
  int flown = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Stream random(seed, 0, 0);
    const std::vector<Gate> gates = draw_gates(random);
    AltitudeLabel label = AltitudeLabel::at((gates[0].floor + gates[0].ceiling) / 2);
    const double start = label.low;
    std::vector<AltitudeLabel> labels{label};
    for (std::size_t k = 1; k < gates.size() && label.alive(); ++k) {
      label.advance(gates[k].at_m - gates[k - 1].at_m, slopes);
      label.clip(gates[k].floor, gates[k].ceiling);
      labels.push_back(label);
    }
    if (!label.alive()) continue;
    ++flown;
    const double end = label.low + random.uniform() * (label.high - label.low);
    const auto string = taut_string(gates, start, end);
    for (const Gate& gate : gates) {
      const double z = gate.at_m == 0 ? start : gate.at_m == gates.back().at_m ? end : altitude_at(string, gate.at_m);
      EXPECT_GE(z, gate.floor - 1e-9) << seed;
      EXPECT_LE(z, gate.ceiling + 1e-9) << seed;
    }
    for (std::size_t i = 1; i < string.size(); ++i) {
      const double slope = (string[i].z - string[i - 1].z) / (string[i].at_m - string[i - 1].at_m);
      EXPECT_LE(slope, slopes.climb + 1e-9) << seed;
      EXPECT_GE(slope, -slopes.descent - 1e-9) << seed;
    }
    EXPECT_NEAR(ascent_of(string), label.ascent_to(end), 1e-6) << seed;
    // Another flight, drawn backward from the end through what the labels allow.
    std::vector<ProfilePoint> other{{gates.back().at_m, end}};
    for (std::size_t k = gates.size() - 1; k-- > 0;) {
      const double step = gates[k + 1].at_m - gates[k].at_m;
      const double low = std::max(labels[k].low, other.back().z - slopes.climb * step);
      const double high = std::min(labels[k].high, other.back().z + slopes.descent * step);
      other.push_back({gates[k].at_m, low + random.uniform() * (high - low)});
    }
    EXPECT_LE(length_of(string), length_of(other) + 1e-9) << seed;
  }
  EXPECT_GT(flown, 100);
}

}  // namespace
}  // namespace alate
