// Random numbers as a pure function of (seed, iteration, ant, draw): no state, so no order of threads shows.
#pragma once

#include <cstdint>

namespace alate {

/// Counter-based generator: draw n is mix(key + n * odd constant), the SplitMix64 finaliser
/// (Steele, Lea, Flood 2014) over a key mixed from seed, iteration and ant in the same way.
class Stream {
 public:
  Stream(std::uint64_t seed, std::uint64_t iteration, std::uint64_t ant)
      : key_(mix(mix(mix(seed) + iteration * kStep) + ant * kStep)) {}

  std::uint64_t bits() { return mix(key_ + kStep * ++draw_); }

  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// Uniform in [0, count), count >= 1 (bias below 2^-32 for counts below 2^32).
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>((static_cast<Wide>(bits()) * count) >> 64);
  }

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15ULL;

  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
  std::uint64_t draw_ = 0;
};

}  // namespace alate
