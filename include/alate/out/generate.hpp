// Scenarios made by a law, for experiments of any size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace alate {

inline constexpr int kMostGeneratedPoints = 2'000'000;

struct CorrectionRequest {
  std::string law = "set1";
  int points = 0;  ///< 1 to kMostGeneratedPoints, start and end not among them.
  std::uint64_t seed = 1;
};

/// Names of the laws: density and limits of the contest's sets (Zhou et al. 2020).
std::vector<std::string> correction_laws();

/// Writes points.csv and scenario.yaml into `folder` (made if missing), whole or not at all, and returns their names.
/// Throws InputError for an unknown law or a folder that cannot be written, std::system_error if the disk fails.
std::vector<std::string> write_corrections(const CorrectionRequest& request, const std::string& folder);

inline constexpr int kLeastGeneratedSide = 100;
inline constexpr int kMostGeneratedSide = 12'000;

struct TerrainRequest {
  std::string law = "canyon";
  int side = 601;  ///< Posts along a side, kLeastGeneratedSide to kMostGeneratedSide, 10 m apart.
  std::uint64_t seed = 1;
};

/// canyon: one that winds from west to east through a high plain, with dead ends. hills: rough ground everywhere.
std::vector<std::string> terrain_laws();

/// Writes terrain.tif and scenario.yaml; else as above. The same request gives the same heights on every machine.
std::vector<std::string> write_terrain(const TerrainRequest& request, const std::string& folder);

}  // namespace alate
