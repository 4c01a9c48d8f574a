#include "space/flight/sheltered_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

constexpr SlopeLimits kSlopes{.climb = 0.15, .descent = 0.2};
constexpr double kStep_m = 40;

/// A band of changing height that a flight from the middle of its first gate may or may not pass.
std::vector<Gate> random_gates(Stream& random) {
  std::vector<Gate> gates;
  double floor = 0;
  double height = 150;
  for (int i = 0; i <= 100; ++i) {
    gates.push_back({20.0 * i, floor, floor + height});
    floor += 6 * (random.uniform() - 0.5);
    height = std::clamp(height + 40 * (random.uniform() - 0.5), 30.0, 300.0);
  }
  return gates;
}

/// Up and down at random, as the slopes allow and brought into the tube.
std::vector<double> random_profile(const std::vector<Gate>& tube, Stream& random) {
  std::vector<double> z{tube.front().floor};
  const double steady = 2 * random.uniform() - 1;
  for (std::size_t i = 1; i < tube.size(); ++i) {
    const double ahead = tube[i].at_m - tube[i - 1].at_m;
    const double slope = std::clamp(steady + random.uniform() - 0.5, -1.0, 1.0);
    const double wish = z.back() + ahead * (slope > 0 ? slope * kSlopes.climb : slope * kSlopes.descent);
    z.push_back(std::clamp(wish, tube[i].floor, tube[i].ceiling));
  }
  return z;
}

bool keeps_slopes(const std::vector<Gate>& tube, const std::vector<double>& z) {
  for (std::size_t i = 1; i < z.size(); ++i) {
    const double ahead = tube[i].at_m - tube[i - 1].at_m;
    const double rise = z[i] - z[i - 1];
    if (rise > ahead * kSlopes.climb + 1e-9 || rise < -ahead * kSlopes.descent - 1e-9) return false;
  }
  return true;
}

/// A threat in the middle of the track that sees what is high.
double exposure(double from_m, double to_m, double z) {
  const double middle = (from_m + to_m) / 2;
  return (to_m - from_m) * 4 * std::exp(-std::pow((middle - 1000) / 400, 2)) * std::clamp(z / 100, 0.0, 2.0);
}

ProfilePrices prices_with(double (*exposure)(double from_m, double to_m, double z)) {
  return {.length = 1,
          .climb = 2,
          .exposure = [exposure](double from_m, double to_m, std::span<const double> levels, std::span<double> all) {
            std::ranges::transform(levels, all.begin(), [&](double z) { return exposure(from_m, to_m, z); });
          }};
}

double cost_of(const std::vector<Gate>& tube, const std::vector<double>& z, const ProfilePrices& prices) {
  double sum = 0;
  for (std::size_t i = 1; i < z.size(); ++i) {
    const double ahead = tube[i].at_m - tube[i - 1].at_m;
    const std::array<double, 1> level{(z[i] + z[i - 1]) / 2};
    std::array<double, 1> exposed{};
    prices.exposure(tube[i - 1].at_m, tube[i].at_m, level, exposed);
    sum +=
        prices.length * std::hypot(ahead, z[i] - z[i - 1]) + prices.climb * std::max(0.0, z[i] - z[i - 1]) + exposed[0];
  }
  return sum;
}

std::vector<double> string_through(const std::vector<Gate>& gates) {
  const auto string = taut_string(gates, gates.front().floor, (gates.back().floor + gates.back().ceiling) / 2);
  std::vector<double> z;
  for (const Gate& gate : gates) z.push_back(altitude_at(string, gate.at_m));
  return z;
}

TEST(ShelteredProfile, TheTubeKeepsTheSlopeLimitsAndItsEnds) {
  int open = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Stream random(seed, 0, 0);
    std::vector<Gate> gates = random_gates(random);
    const double low = gates.back().floor + 20;
    gates.back() = {gates.back().at_m, low, low + 30};
    const std::vector<Gate> tube = tube_of(gates, 50, kSlopes);
    if (tube.empty()) continue;
    ++open;
    std::vector<double> floors;
    std::vector<double> ceilings;
    for (std::size_t i = 0; i < tube.size(); ++i) {
      floors.push_back(tube[i].floor);
      ceilings.push_back(tube[i].ceiling);
      EXPECT_GE(tube[i].floor, i == 0 ? 50 : gates[i].floor);
      EXPECT_LE(tube[i].ceiling, i == 0 ? 50 : gates[i].ceiling);
    }
    EXPECT_TRUE(keeps_slopes(tube, floors)) << seed;
    EXPECT_TRUE(keeps_slopes(tube, ceilings)) << seed;
    EXPECT_GE(floors.back(), low);
    EXPECT_LE(ceilings.back(), low + 30);
  }
  EXPECT_GT(open, 50);
}

TEST(ShelteredProfile, NoTubeWhereTheEndIsTooHigh) {
  EXPECT_TRUE(tube_of({{0, 0, 500}, {1000, 201, 500}}, 50, kSlopes).empty());
  EXPECT_FALSE(tube_of({{0, 0, 500}, {1000, 199, 500}}, 50, kSlopes).empty());
}

TEST(ShelteredProfile, NoRandomProfileIsCheaper) {
  const ProfilePrices prices = prices_with(exposure);
  int compared = 0;
  double saved = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Stream random(seed, 1, 0);
    const std::vector<Gate> gates = random_gates(random);
    const std::vector<Gate> tube = tube_of(gates, 50, kSlopes);
    if (tube.empty()) continue;
    const std::vector<double> best = string_through(sheltered_lane(tube, kStep_m, kSlopes, prices));
    EXPECT_TRUE(keeps_slopes(tube, best)) << seed;
    const double cost = cost_of(tube, best, prices);
    for (int trial = 0; trial < 200; ++trial) {
      const std::vector<double> other = random_profile(tube, random);
      ASSERT_TRUE(keeps_slopes(tube, other)) << seed;
      EXPECT_LE(cost, 1.005 * cost_of(tube, other, prices)) << seed << ' ' << trial;
      ++compared;
    }
    saved += 1 - cost / cost_of(tube, string_through(tube), prices);
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(saved, 0);
}

TEST(ShelteredProfile, WithoutExposureTheStringIsAsGood) {
  const ProfilePrices prices = prices_with([](double, double, double) { return 0.0; });
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Stream random(seed, 2, 0);
    const std::vector<Gate> gates = random_gates(random);
    const std::vector<Gate> tube = tube_of(gates, 50, kSlopes);
    if (tube.empty()) continue;
    const double lane = cost_of(tube, string_through(sheltered_lane(tube, kStep_m, kSlopes, prices)), prices);
    std::vector<Gate> same_end = tube;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 20; ++k) {
      const double z = tube.back().floor + (tube.back().ceiling - tube.back().floor) * k / 20;
      same_end.back().floor = same_end.back().ceiling = z;
      least = std::min(least, cost_of(tube, string_through(same_end), prices));
    }
    EXPECT_LE(lane, 1.005 * least) << seed;
  }
}

}  // namespace
}  // namespace alate
