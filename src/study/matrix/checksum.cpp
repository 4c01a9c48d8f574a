#include "study/matrix/checksum.hpp"

#include <fmt/core.h>

namespace alate {

std::string checksum(std::string_view text) {
  constexpr std::uint64_t kOffset = 0xcbf29ce484222325ULL;
  constexpr std::uint64_t kPrime = 0x100000001b3ULL;
  std::uint64_t sum = kOffset;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * kPrime;
  return fmt::format("{:016x}", sum);
}

}  // namespace alate
