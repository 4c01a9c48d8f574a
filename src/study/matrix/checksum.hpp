// A number that tells contents apart.
#pragma once

#include <cstdint>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace alate {

/// FNV-1a, 64 bits (Fowler, Noll, Vo), of all that was added. The same on every machine of the same byte order.
class Checksum {
 public:
  void add(std::string_view bytes) {
    constexpr std::uint64_t kPrime = 0x100000001b3ULL;
    for (const char c : bytes) sum_ = (sum_ ^ static_cast<unsigned char>(c)) * kPrime;
  }
  /// Numbers that lie one behind the other.
  template <std::ranges::contiguous_range Numbers>
    requires std::is_arithmetic_v<std::ranges::range_value_t<Numbers>>
  void add_numbers(const Numbers& numbers) {
    const std::span all(numbers);
    add({reinterpret_cast<const char*>(all.data()), all.size_bytes()});
  }
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

/// Of one text.
std::string checksum(std::string_view text);

}  // namespace alate
