#include "study/yin2021/maps.hpp"

#include <fmt/core.h>

#include <optional>

#include "alate/data/scenario_file.hpp"
#include "search/grid/astar.hpp"

namespace alate::yin2021 {

namespace {

std::optional<double> shortest_way(const HeightGrid& grid) {
  const BitGrid cells(grid);
  Executor executor(1);
  RunContext run(executor, {});
  const GridWay way = GridAStar(cells).find(BitGrid::place(0, grid.rows - 1), BitGrid::place(grid.columns - 1, 0), run);
  return way.found ? std::optional(way.length.value()) : std::nullopt;
}

}  // namespace

Maps draw_maps(Size size, std::size_t count) {
  Maps maps;
  for (int seed = 1; maps.cases.size() < count; ++seed) {
    const std::string name = fmt::format("{} map {}", size_name(size), seed);
    Site site = load_site(parse_scenario(scenario_text(size, seed), name));
    const std::optional<double> length = shortest_way(*site.grid);
    if (!length) {
      ++maps.passed_over;
      continue;
    }
    maps.cases.push_back({.name = name, .world = World(std::move(site))});
    maps.seeds.push_back(seed);
    maps.optimum.push_back(*length);
  }
  return maps;
}

}  // namespace alate::yin2021
