// Planners that search a terrain lattice without chance.
#include <algorithm>
#include <array>

#include "plan/attitude/lattice_parameters.hpp"
#include "plan/parameter_values.hpp"
#include "plan/terrain/terrain_plan.hpp"
#include "plan/terrain/terrain_planners.hpp"
#include "search/lattice_astar.hpp"
#include "search/lattice_theta.hpp"
#include "space/taut_route.hpp"

namespace alate {

namespace {

/// Of the lattice's parameters those that an exact search understands, and how its route is pulled.
std::vector<Parameter> search_parameters(bool with_fitness) {
  constexpr std::array kLax{"safety", "dead_ends", "constraints", "penalty"};
  constexpr std::array kFitness{"fitness",     "weight_length", "weight_height",
                                "weight_turn", "height_above",  "angle_unit"};
  std::vector<Parameter> all = lattice_parameters();
  std::erase_if(all, [&](const Parameter& parameter) {
    return std::ranges::find(kLax, parameter.name) != kLax.end() ||
           (!with_fitness && std::ranges::find(kFitness, parameter.name) != kFitness.end());
  });
  all.push_back({.name = "polish",
                 .default_value = word("none"),
                 .choices = {"none", "taut"},
                 .help = "What becomes of the route found: taut: it leaves the lattice and is pulled taut, for the "
                         "scenario's objective.",
                 .source = "alate"});
  for (Parameter& parameter : all) parameter.help = "Over terrain: " + parameter.help;
  return all;
}

LatticeWay best_moves(const Problem& /*problem*/, const TerrainLattice& lattice, RunContext& run) {
  return lattice_astar(lattice, run);
}

/// The cheaper of the any-angle route and the best string of moves, which is sought first: it costs little beside the
/// lattice, and finds ways that Theta* misses.
LatticeWay best_angle(const Problem& problem, const TerrainLattice& lattice, RunContext& run) {
  LatticeWay way = lattice_astar(lattice, run);
  if (!way.finished) return way;
  LatticeWay any = lattice_theta(problem.world, lattice, run);
  way.expansions += any.expansions;
  if (any.best && (!way.best || any.best->score < way.best->score)) way.best = std::move(any.best);
  return way;
}

using Search = LatticeWay (*)(const Problem&, const TerrainLattice&, RunContext&);

class TerrainPlanner {
 public:
  TerrainPlanner(ParamValues values, Search search) : values_(std::move(values)), search_(search) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    Plan plan = plan_over_terrain(problem, run, lattice_options(values_),
                                  [&](const TerrainLattice& lattice) { return find(problem, lattice, run); });
    if (plan.route.states.size() > 1) plan.why = what_it_is();
    return plan;
  }

 private:
  bool pulls() const { return values_.text("polish") == "taut"; }

  LatticeFound find(const Problem& problem, const TerrainLattice& lattice, RunContext& run) const {
    const LatticeWay way = search_(problem, lattice, run);
    LatticeFound found{.moves = way.expansions, .is_exhausted = way.finished && !way.best};
    if (!way.best) return found;
    found.places = way.best->places;
    if (pulls()) found.places = TautRoute(problem.world).pull(found.places, lattice.frame().steps_m().x(), run);
    return found;
  }

  /// Nothing here is the optimum of what was asked: a route off the lattice may be shorter.
  std::string what_it_is() const {
    if (search_ == best_angle)
      return "no route over the lattice's moves is cheaper, but other routes through the air may be";
    if (pulls()) return "it is the best string of moves over the lattice, pulled taut";
    return "it is the best string of moves over the lattice; routes that leave the lattice may be cheaper";
  }

  ParamValues values_;
  Search search_;
};

PlannerEntry entry(std::string_view name, std::string_view help, bool with_fitness, Search search) {
  return {.name = std::string(name),
          .help = std::string(help),
          .can = {.deterministic = true, .terrain = true, .threats = true, .space = "terrain lattice"},
          .presets = {{.name = "default", .help = "As the parameters say."}},
          .parameters = ParamTable(search_parameters(with_fitness)),
          .refuses = terrain_refusal,
          .make = [search](const ParamValues& values) { return Planner(TerrainPlanner(values, search)); }};
}

}  // namespace

PlannerEntry terrain_astar_entry() {
  return entry("astar", "Over terrain: the best string of moves over the lattice of terrain-aco, by A*.", true,
               best_moves);
}

PlannerEntry terrain_theta_star_entry() {
  return entry("theta-star",
               "Over terrain: straight legs at any angle between nodes of the lattice of terrain-aco, by Lazy Theta* "
               "(Nash, Koenig and Tovey 2010); never dearer than astar.",
               false, best_angle);
}

bool is_over_terrain(const Site& site) { return site.has_ground() && !site.grid; }

}  // namespace alate
