// Laws of altitude labels and of the taut string, against profiles drawn at random, in numbers that round.
#include "space/flight/altitude_label.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "space/flight/taut_string.hpp"

namespace alate {
namespace {

constexpr double kRounding = 1e-9;

using Band = std::vector<Gate>;
using Profile = std::vector<double>;

class Random {
 public:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(engine_); }
  bool often(double chance) { return between(0, 1) < chance; }

 private:
  std::mt19937_64 engine_{7};
};

/// Uneven steps; floor and ceiling wander, touch here and there, and are steeper than the aircraft can fly.
Band random_band(Random& random, std::size_t count) {
  Band band;
  double at = 0;
  double floor = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double height = random.often(0.1) ? 0 : random.between(0, 25);
    band.push_back({.at_m = at, .floor = floor, .ceiling = floor + height});
    const double step = random.often(0.1) ? 1e-3 : random.between(1, 60);
    at += step;
    floor += step * random.between(-0.35, 0.35);
  }
  return band;
}

/// Labels at every gate, the last one dead where the band cannot be flown.
std::vector<AltitudeLabel> forward(const Band& band, double z, const SlopeLimits& slopes) {
  std::vector<AltitudeLabel> labels{AltitudeLabel::at(z)};
  labels.back().clip(band[0].floor, band[0].ceiling);
  for (std::size_t i = 1; i < band.size() && labels.back().alive(); ++i) {
    AltitudeLabel label = labels.back();
    label.advance(band[i].at_m - band[i - 1].at_m, slopes);
    label.clip(band[i].floor, band[i].ceiling);
    labels.push_back(label);
  }
  return labels;
}

double ascent_of(const Profile& profile) {
  double sum = 0;
  for (std::size_t i = 1; i < profile.size(); ++i) sum += std::max(0.0, profile[i] - profile[i - 1]);
  return sum;
}

double length_of(const Band& band, const Profile& profile) {
  double sum = 0;
  for (std::size_t i = 1; i < profile.size(); ++i)
    sum += std::hypot(band[i].at_m - band[i - 1].at_m, profile[i] - profile[i - 1]);
  return sum;
}

void expect_flyable(const Band& band, const Profile& profile, const SlopeLimits& slopes) {
  for (std::size_t i = 0; i < band.size(); ++i) {
    ASSERT_GE(profile[i], band[i].floor - kRounding);
    ASSERT_LE(profile[i], band[i].ceiling + kRounding);
    if (i == 0) continue;
    const double ahead = band[i].at_m - band[i - 1].at_m;
    ASSERT_LE(profile[i] - profile[i - 1], slopes.climb * ahead + kRounding);
    ASSERT_GE(profile[i] - profile[i - 1], -slopes.descent * ahead - kRounding);
  }
}

/// A profile that goes where chance leads it; shorter than the band where it gets stuck.
Profile random_profile(const Band& band, double z, const SlopeLimits& slopes, Random& random) {
  Profile profile{z};
  const double habit = random.between(0, 1);
  for (std::size_t i = 1; i < band.size(); ++i) {
    const double ahead = band[i].at_m - band[i - 1].at_m;
    const double low = std::max(band[i].floor, profile.back() - slopes.descent * ahead);
    const double high = std::min(band[i].ceiling, profile.back() + slopes.climb * ahead);
    if (low > high) break;
    const double part = random.often(0.5) ? habit : random.between(0, 1);
    profile.push_back(low + part * (high - low));
  }
  return profile;
}

/// Backward from an altitude within the last label, always to the nearest one that leads there.
Profile profile_to(const Band& band, const std::vector<AltitudeLabel>& labels, double z, const SlopeLimits& slopes) {
  Profile profile(labels.size());
  profile.back() = z;
  for (std::size_t i = labels.size() - 1; i > 0; --i) {
    const double ahead = band[i].at_m - band[i - 1].at_m;
    const double low = std::max(labels[i - 1].low, profile[i] - slopes.climb * ahead);
    const double high = std::min(labels[i - 1].high, profile[i] + slopes.descent * ahead);
    EXPECT_LE(low, high + kRounding);
    profile[i - 1] = std::min(std::max(profile[i], low), std::max(low, high));
  }
  return profile;
}

struct Case {
  Band band;
  double z = 0;
  SlopeLimits slopes;
  std::vector<AltitudeLabel> labels;
};

/// Bands that can be flown, with the labels along them.
std::vector<Case> flyable_cases(std::size_t count) {
  Random random;
  std::vector<Case> cases;
  while (cases.size() < count) {
    Case one{.band = random_band(random, 4 + cases.size() % 40),
             .slopes = {random.between(0.05, 0.3), random.between(0.05, 0.3)}};
    one.z = random.between(one.band[0].floor, one.band[0].ceiling);
    one.labels = forward(one.band, one.z, one.slopes);
    if (one.labels.back().alive()) cases.push_back(one);
  }
  return cases;
}

Profile taut(const Case& one, double z_to) {
  const auto bends = taut_string(one.band, one.z, z_to);
  Profile profile;
  for (const Gate& gate : one.band) profile.push_back(altitude_at(bends, gate.at_m));
  return profile;
}

TEST(AltitudeLaws, HoldsEveryProfileAndItsAscent) {
  Random random;
  for (const Case& one : flyable_cases(300)) {
    for (int i = 0; i < 200; ++i) {
      const Profile profile = random_profile(one.band, one.z, one.slopes, random);
      for (std::size_t k = 0; k < profile.size(); ++k) {
        ASSERT_GE(profile[k], one.labels[k].low - kRounding);
        ASSERT_LE(profile[k], one.labels[k].high + kRounding);
      }
      const double ascent = ascent_of(profile);
      ASSERT_GE(ascent, one.labels[profile.size() - 1].ascent_to(profile.back()) - kRounding);
    }
  }
}

TEST(AltitudeLaws, EveryAltitudeIsAttained) {
  for (const Case& one : flyable_cases(500)) {
    const AltitudeLabel& last = one.labels.back();
    for (const double z : {last.low, last.high, last.free, (last.low + last.high) / 2})
      expect_flyable(one.band, profile_to(one.band, one.labels, z, one.slopes), one.slopes);
  }
}

TEST(AltitudeLaws, DeadMeansThatNoProfileGetsThrough) {
  Random random;
  int dead = 0;
  for (int i = 0; i < 400; ++i) {
    const Band band = random_band(random, 12);
    const SlopeLimits slopes{0.15, 0.15};
    const double z = random.between(band[0].floor, band[0].ceiling);
    if (forward(band, z, slopes).back().alive()) continue;
    ++dead;
    for (int k = 0; k < 100; ++k) ASSERT_LT(random_profile(band, z, slopes, random).size(), band.size());
  }
  EXPECT_GT(dead, 50);
}

TEST(AltitudeLaws, KnotsOnStraightStretchesChangeNothing) {
  for (const Case& one : flyable_cases(200)) {
    Band finer;
    for (std::size_t i = 0; i < one.band.size(); ++i) {
      if (i > 0) {
        const Gate& a = one.band[i - 1];
        const Gate& b = one.band[i];
        for (const double t : {0.25, 0.7})
          finer.push_back({.at_m = a.at_m + t * (b.at_m - a.at_m),
                           .floor = a.floor + t * (b.floor - a.floor),
                           .ceiling = a.ceiling + t * (b.ceiling - a.ceiling)});
      }
      finer.push_back(one.band[i]);
    }
    const AltitudeLabel last = forward(finer, one.z, one.slopes).back();
    ASSERT_TRUE(last.low <= last.high + kRounding);
    ASSERT_NEAR(last.low, one.labels.back().low, kRounding);
    ASSERT_NEAR(last.high, one.labels.back().high, kRounding);
    ASSERT_NEAR(last.ascent, one.labels.back().ascent, kRounding);
    ASSERT_NEAR(last.free, one.labels.back().free, kRounding);
  }
}

void expect_meetings(const Case& one, double z_to) {
  BackwardLabel back{z_to, z_to, 0, z_to};
  for (std::size_t i = one.band.size(); i-- > 0;) {
    back.clip(one.band[i].floor, one.band[i].ceiling);
    const auto met = meet(one.labels[i], back);
    ASSERT_TRUE(met.has_value()) << "an empty tube on a way that can be flown, gate " << i;
    ASSERT_NEAR(met->ascent, one.labels.back().ascent_to(z_to), 1e-8);
    if (i > 0) back.advance(one.band[i].at_m - one.band[i - 1].at_m, one.slopes);
  }
}

TEST(AltitudeLaws, ForwardAndBackwardMeetEverywhereInTheSameAscent) {
  for (const Case& one : flyable_cases(500)) {
    const AltitudeLabel& last = one.labels.back();
    for (const double z_to : {last.low, last.high, last.free}) expect_meetings(one, z_to);
  }
}

TEST(AltitudeLaws, AFloorAsSteepAsTheClimbIsFollowed) {
  const SlopeLimits slopes{0.15, 0.1};
  for (const double step : {0.1, 1.0 / 3, 7.7}) {
    AltitudeLabel label = AltitudeLabel::at(100);
    for (int i = 1; i <= 1000; ++i) {
      label.advance(step, slopes);
      label.clip(100 + 0.15 * step * i, 100 + 0.15 * step * i);
      ASSERT_TRUE(label.alive()) << step << " after " << i;
    }
    label.advance(step, slopes);
    label.clip(label.high + 1e-6, 1e4);
    EXPECT_FALSE(label.alive());
  }
}

TEST(AltitudeLaws, TouchingBoundsAreMet) {
  // A goal at the very end of what can be climbed, by steps whose sum rounds.
  for (const double step : {0.1, 1.0 / 3, 7.7}) {
    const SlopeLimits slopes{0.15, 0.1};
    AltitudeLabel label = AltitudeLabel::at(100);
    for (int i = 0; i < 1000; ++i) label.advance(step, slopes);
    BackwardLabel back{label.high, label.high, 0, label.high};
    for (int i = 0; i < 1000; ++i) back.advance(step, slopes);
    const auto met = meet(AltitudeLabel::at(100), back);
    EXPECT_TRUE(met.has_value()) << step << " misses by " << back.low - 100;
  }
}

TEST(AltitudeLaws, ATautStringKeepsBandAndSlopesAndIsShortest) {
  Random random;
  for (const Case& one : flyable_cases(400)) {
    const AltitudeLabel& last = one.labels.back();
    for (const double z_to : {last.low, last.high, last.free}) {
      const Profile string = taut(one, z_to);
      ASSERT_NEAR(string.back(), z_to, kRounding);
      expect_flyable(one.band, string, one.slopes);
      ASSERT_NEAR(ascent_of(string), last.ascent_to(z_to), 1e-8);
      const Profile other = profile_to(one.band, one.labels, z_to, one.slopes);
      ASSERT_LE(length_of(one.band, string), length_of(one.band, other) + kRounding);
    }
    for (int i = 0; i < 50; ++i) {
      const Profile profile = random_profile(one.band, one.z, one.slopes, random);
      if (profile.size() < one.band.size()) continue;
      const Profile string = taut(one, profile.back());
      ASSERT_LE(length_of(one.band, string), length_of(one.band, profile) + kRounding);
      ASSERT_LE(ascent_of(string), ascent_of(profile) + 1e-8);
    }
  }
}

}  // namespace
}  // namespace alate
