#include "study/yin2021/maps.hpp"

#include <fmt/core.h>

#include <numbers>

#include "alate/data/scenario_file.hpp"
#include "search/grid_distance.hpp"

namespace alate::yin2021 {

namespace {

double shortest_way(const HeightGrid& grid) {
  const GridSpace space(grid, {0, grid.rows - 1, grid.columns - 1, 0}, std::numbers::sqrt2, {});
  return grid_distances(space, space.start())[space.goal()];
}

}  // namespace

Maps draw_maps(Size size, std::size_t count) {
  Maps maps;
  for (int seed = 1; maps.cases.size() < count; ++seed) {
    const std::string name = fmt::format("{} map {}", size_name(size), seed);
    Site site = load_site(parse_scenario(scenario_text(size, seed), name));
    const double length = shortest_way(*site.grid);
    if (!(length < kInfinity)) {
      ++maps.passed_over;
      continue;
    }
    maps.cases.push_back({.name = name, .world = World(std::move(site))});
    maps.seeds.push_back(seed);
    maps.optimum.push_back(length);
  }
  return maps;
}

}  // namespace alate::yin2021
