#include "study/matrix/checksum.hpp"

#include <fmt/core.h>

namespace alate {

std::string Checksum::text() const { return fmt::format("{:016x}", sum_); }

std::string checksum(std::string_view text) {
  Checksum sum;
  sum.add(text);
  return sum.text();
}

}  // namespace alate
