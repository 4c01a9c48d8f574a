#include "study/mai2023/optimum.hpp"

#include "alate/core/executor.hpp"
#include "plan/attitude/lattice_parameters.hpp"

namespace alate::mai2023 {

std::optional<LatticeOptimum> least_fitness(const World& world, const ParamValues& values) {
  const LatticeOptions options = lattice_options(values);
  Executor alone(1);
  RunContext run(alone, {});
  return lattice_optimum(TerrainLattice(world, LatticeFrame(world, options.steps), options, run));
}

}  // namespace alate::mai2023
