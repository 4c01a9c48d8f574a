// Eight values side by side, one for each direction of a grid.
//
// In two registers of four lanes, what every x86-64 has; written for any compiler that knows vectors of the GNU kind.
// Every sum has a fixed order, so all processors give the same bits.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace alate {

struct Octet {
  using Quad = float __attribute__((vector_size(16)));
  using Bits = std::int32_t __attribute__((vector_size(16)));

  Quad low{}, high{};

  static Octet load(const float* row) {
    Octet octet;
    std::memcpy(&octet.low, row, sizeof octet.low);
    std::memcpy(&octet.high, row + 4, sizeof octet.high);
    return octet;
  }
  static Octet all(float value) { return {Quad{} + value, Quad{} + value}; }
  float operator[](unsigned direction) const { return direction < 4 ? low[direction] : high[direction - 4]; }

  friend Octet operator+(const Octet& a, const Octet& b) { return {a.low + b.low, a.high + b.high}; }
  friend Octet operator-(const Octet& a, const Octet& b) { return {a.low - b.low, a.high - b.high}; }
  friend Octet operator*(const Octet& a, const Octet& b) { return {a.low * b.low, a.high * b.high}; }
};

inline Octet::Quad larger(const Octet::Quad& a, const Octet::Quad& b) { return a > b ? a : b; }

inline Octet absolute(const Octet& values) {
  using Bits = Octet::Bits;
  constexpr Bits kNoSign = Bits{} + 0x7FFFFFFF;
  return {std::bit_cast<Octet::Quad>(std::bit_cast<Bits>(values.low) & kNoSign),
          std::bit_cast<Octet::Quad>(std::bit_cast<Bits>(values.high) & kNoSign)};
}

/// Which of the eight, all bits of a lane or none.
struct OctetMask {
  Octet::Bits low{}, high{};

  /// Bit d: lane d.
  static OctetMask of(unsigned members) {
    const auto all = Octet::Bits{} + static_cast<std::int32_t>(members);
    return {(all & Octet::Bits{1, 2, 4, 8}) != 0, (all & Octet::Bits{16, 32, 64, 128}) != 0};
  }
  OctetMask others() const { return {~low, ~high}; }
  /// The values of its members, 0 elsewhere.
  Octet keep(const Octet& values) const {
    return {std::bit_cast<Octet::Quad>(std::bit_cast<Octet::Bits>(values.low) & low),
            std::bit_cast<Octet::Quad>(std::bit_cast<Octet::Bits>(values.high) & high)};
  }
};

/// How many lanes are set.
inline unsigned count_lanes(const OctetMask& mask) {
  Octet::Bits sum = mask.low + mask.high;  // -1 each
  sum += __builtin_shufflevector(sum, sum, 2, 3, 2, 3);
  return static_cast<unsigned>(-(sum[0] + sum[1]));
}

/// Random proportional rule: the first direction up to which weights sum to more than uniform times all of them, 8 if
/// nothing weighs anything. Weights >= 0. Lanes are joined two by two, then four by four: a weight of 0 adds nothing to
/// the sum before it, whatever is rounded, so it is never drawn.
inline unsigned draw(const Octet& weights, float uniform) {
  using Quad = Octet::Quad;
  using Pair = std::uint64_t __attribute__((vector_size(16)));
  const auto running = [](Quad sums) {
    sums += std::bit_cast<Quad>(std::bit_cast<Pair>(sums) << 32U);
    return sums + __builtin_shufflevector(Quad{}, sums, 0, 1, 5, 5);
  };
  const Quad low = running(weights.low);
  const Quad high = running(weights.high) + __builtin_shufflevector(low, low, 3, 3, 3, 3);
  const Quad point = __builtin_shufflevector(high, high, 3, 3, 3, 3) * uniform;
  return count_lanes({low <= point, high <= point});
}

/// The direction with the largest weight, the first of equal ones; 8 if none is above 0.
inline unsigned heaviest(const Octet& weights) {
  using Quad = Octet::Quad;
  const auto largest = [](Quad quad) {
    quad = larger(quad, __builtin_shufflevector(quad, quad, 2, 3, 0, 1));
    return larger(quad, __builtin_shufflevector(quad, quad, 1, 0, 3, 2));
  };
  constexpr Octet kToEnd{.low = {8, 7, 6, 5}, .high = {4, 3, 2, 1}};
  const Quad most = largest(larger(weights.low, weights.high));
  const Octet first = OctetMask{weights.low == most, weights.high == most}.keep(kToEnd);
  const auto to_end = static_cast<int>(largest(larger(first.low, first.high))[0]);
  return most[0] > 0 ? static_cast<unsigned>(8 - to_end) : 8U;
}

}  // namespace alate
