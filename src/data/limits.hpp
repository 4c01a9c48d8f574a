// Limits of what is read from outside, in one place. Beyond a limit there is a fault that names it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace alate {

inline constexpr std::size_t kMaxScenarioBytes = 1'048'576;  ///< 1 MiB of YAML.
inline constexpr std::size_t kMaxNesting = 32;               ///< Groups and lists within each other.
inline constexpr std::size_t kMaxListItems = 10'000;         ///< Threats; peaks.
inline constexpr std::size_t kMaxAngles = 100;               ///< Angles in one list.
inline constexpr std::size_t kMaxAttitudeMoves = 10'000;     ///< Rolls times pitches times yaws.
inline constexpr double kMaxMagnitude = 1e9;                 ///< Of any number in a scenario.
inline constexpr std::size_t kMaxFaults = 100;               ///< Shown one by one; the rest are counted.
inline constexpr std::size_t kMaxRouteBytes = 67'108'864;    ///< 64 MiB of a route or mission file.
inline constexpr std::size_t kMaxRouteStates = 100'000;      ///< Positions of one route.
inline constexpr std::size_t kMaxPointsBytes = 268'435'456;  ///< 256 MiB of correction points.
inline constexpr std::size_t kMaxPoints = 4'000'000;         ///< Correction points, start and end among them.
inline constexpr int kMaxPointId = 99'999'999;               ///< Ids of correction points start at 0.

inline constexpr std::size_t kMaxStudyScenarios = 10'000;  ///< After ranges have been written out.
inline constexpr std::size_t kMaxStudyPlanners = 100;
inline constexpr std::size_t kMaxStudyBudgets = 20;
inline constexpr std::size_t kMaxStudySeeds = 100'000;
inline constexpr std::size_t kMaxStudyRuns = 1'000'000;
inline constexpr std::size_t kMaxStudyCells = 300'000'000;  ///< Cells and posts of all scenarios together.

inline constexpr std::size_t kMaxGridBytes = 33'554'432;  ///< 32 MiB of a grid map.
inline constexpr int kMaxGridSide = 10'000;               ///< Columns; rows.
inline constexpr std::int64_t kMaxGridCells = 16'000'000;
inline constexpr std::size_t kMaxVoxelBytes = 268'435'456;  ///< 256 MiB of a voxel map.
inline constexpr int kMaxVoxelSide = 2'000;                 ///< Cells along an axis.
inline constexpr std::int64_t kMaxVoxels = 100'000'000;
inline constexpr std::size_t kMaxScenBytes = 67'108'864;  ///< 64 MiB of benchmark tasks.
inline constexpr std::size_t kMaxScenRows = 1'000'000;
inline constexpr int kMaxGridSeed = 2'000'000'000;
inline constexpr double kLeastCell = 0.01;   ///< m
inline constexpr double kMostCell = 10'000;  ///< m

inline constexpr std::int64_t kMaxRasterCells = 150'000'000;
/// Raster heights outside these are no ground on Earth but voids that nobody marked as such.
inline constexpr double kLowestGround = -12'000;  ///< m
inline constexpr double kHighestGround = 9'000;   ///< m

}  // namespace alate
