// A shaded picture of the ground: layer tints for height, light from the north-west for shape.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "alate/data/site.hpp"
#include "out/report/png.hpp"

namespace alate {

/// One tint and the heights it stands for.
struct HeightBand {
  double from_m = 0;
  double to_m = 0;
  Rgb color{};
};

struct Hillshade {
  IndexedImage image;             ///< Its upper left is the north-west corner of the area.
  std::vector<HeightBand> bands;  ///< Upwards; empty without known ground.
  bool has_unknown = false;       ///< Is some of the area without known ground (hatched grey)?
};

/// Up to eight tints for these heights; none without a height that is a number.
std::vector<HeightBand> height_bands(std::span<const float> heights);

/// Samples the ground over `area` at about `columns` columns, fewer where the terrain holds no more.
/// Shading after Horn (1981): Lambert's law, sun at azimuth 315 and altitude 45 degrees, relief exaggerated where the
/// land is gentle.
Hillshade hillshade(const Site& site, const Box2& area, int columns);

/// The tints with the heights they begin at, an item of a key; `title` is HTML.
std::string height_key(const Hillshade& ground, const char* title);

}  // namespace alate
