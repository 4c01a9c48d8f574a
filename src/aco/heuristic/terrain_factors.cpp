#include "aco/heuristic/terrain_factors.hpp"

#include <algorithm>
#include <cmath>

#include "aco/heuristic/lattice_rows.hpp"

namespace alate {

double terrain_factors(const Vec3& step, const Vec3& rest, double height, bool literal_one) {
  constexpr double kLeast = 1e-3;                     // far below the sea eq. (12) has a pole
  const double m = 1 / std::max(1 + height, kLeast);  // eq. (12)
  const double ahead = literal_one ? 1 : step.x() * step.x();
  const double first = std::sqrt(ahead + step.y() * step.y() + step.z() * step.z());
  return m / (first + std::sqrt(1 + rest.squaredNorm()));  // eq. (13)
}

AlignedFloats terrain_factor_table(const TerrainLattice& lattice, const TerrainFactorRule& rule) {
  constexpr double kKm = 1000;
  const LatticeFrame& frame = lattice.frame();
  const bool in_km = rule.unit == TerrainFactorRule::Unit::km;
  const Vec3 unit = in_km ? Vec3(kKm, kKm, kKm) : frame.steps_m();
  const auto factors = [&](TerrainLattice::Node /*node*/, const Vec3& to, unsigned move) {
    const Vec3 step = frame.along(frame.shifts()[move].leg).cwiseQuotient(unit);
    const Vec3 rest = frame.along(frame.goal() - to).cwiseQuotient(unit);
    return terrain_factors(step, rest, to.z() / unit.z(), rule.literal_one);
  };
  return lattice_rows(lattice, factors, PowerOfShare{rule.beta});
}

}  // namespace alate
