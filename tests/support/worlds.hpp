// The worlds of examples/worlds: ground of its own to each, flown 60 to 400 m ("wide") or 50 to 120 m ("narrow") above.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "alate/data/scenario_file.hpp"
#include "support/shared_data.hpp"

namespace alate::test {

struct FlightWorld {
  std::string name;
  std::string dem;  ///< Among the shared data; empty: the world's own.

  bool has_ground() const { return dem.empty() || std::filesystem::exists(shared_data(dem)); }
};

inline const std::vector<FlightWorld>& flight_worlds() {
  static const std::vector<FlightWorld> kWorlds{{"jacksboro", ""},
                                                {"canyon", ""},
                                                {"lowceiling", ""},
                                                {"davos", "terrain/swiss/davosdorf.tif"},
                                                {"sertig", "terrain/swiss/sertig_valley.tif"},
                                                {"n46e008", "terrain/srtm3/N46E008.tif"},
                                                {"aconcagua", "terrain/srtm3/S33W071.tif"}};
  return kWorlds;
}

inline constexpr std::array<const char*, 2> kBandNames{"wide", "narrow"};

inline Scenario world_scenario(const FlightWorld& world, const std::string& band) {
  const std::string file = ALATE_SOURCE_DIR "/examples/worlds/" + world.name + "-" + band + ".yaml";
  if (world.dem.empty()) return load_scenario(file);
  return load_scenario(file, {"terrain.dem=" + shared_data(world.dem).string()});
}

}  // namespace alate::test
