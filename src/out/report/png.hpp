// Small PNG pictures in memory.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace alate {

using Rgb = std::array<std::uint8_t, 3>;

/// A picture of up to 256 colours, row-major from the upper left.
struct IndexedImage {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> pixels;
  std::vector<Rgb> palette;
};

/// The bytes of a PNG file. Throws std::runtime_error if libpng fails (out of memory).
std::string to_png(const IndexedImage& image);

}  // namespace alate
