// What every output says about its ground, its heights and its limits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/out/result.hpp"

namespace alate {

/// Where the ground heights come from. Empty strings where there is no ground.
struct GroundNote {
  std::string kind;  ///< "raster", "peaks", "grid" or "none".
  std::string terrain;
  std::string crs;
  std::string datum;
  std::optional<double> cell_m;
  std::optional<std::size_t> voids;
};

GroundNote ground_note(const Site& site);

/// Planning help, not clearance to fly; what is not in the terrain; the datum. One paragraph.
std::string notice(const Site& site);

/// Warnings of the site, then of the run, each once.
std::vector<std::string> all_warnings(const Result& result);

/// "at most 10.5 % above the best possible", or why that cannot be said.
std::string gap_in_words(const Result& result);

/// "96.0 %"; "100 %" and "0 %" only where nothing, or everything, can go wrong.
std::string chance_in_words(double chance);

/// The first few routes of a front in a sentence; empty for fewer than two.
std::string front_in_words(const std::vector<FrontPoint>& front);

/// "812 m", "26.7 km".
std::string length_in_words(double metres);

}  // namespace alate
