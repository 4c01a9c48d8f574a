// Guidance round terrain and threats: cost to the goal of a relaxed problem.
//
// The relaxed aircraft is a point without heading on coarse cells. Its altitude is a real number between floor and
// ceiling, and may change between neighbouring cells as far as the climb and descent limits allow, so that ridges
// which cannot be climbed in time are rounded. The value of a cell is a function of altitude: samples with linear
// interpolation between them.
//
// Update of cell a at altitude z from neighbour b: U_b(z) = min over reachable z' of V_b(z') + climb * (z' - z)+;
// then V_a(z) = min(U_b + c |ab|), and for a pair of neighbours (straight, diagonal) the upwind update of
// Tsitsiklis 1995, U_s + sqrt((c h)^2 - (U_s - U_d)^2), so that directions between the eight are not dearer.
// c = length + threat * exposure per metre at (a, z). Within a cell altitude changes on circles, at the price of their
// length. Label-correcting from the goal, cheapest first.
//
// It is a guide, no bound and no proof: cells are coarse, floors are optimistic, values are interpolated.
// Deterministic. About 12000 cells x 6 altitudes.
#pragma once

#include <queue>

#include "alate/core/run_context.hpp"
#include "space/coarse_band.hpp"

namespace alate {

class CostToGo {
 public:
  /// Only for the physical objective. Stops early, with what it has, when `run` says so.
  CostToGo(const World& world, RunContext& run);

  /// Estimated cost from `position` to the goal; infinite where no way is seen.
  double operator()(const Vec3& position) const;

  /// Centre of the cell nearest to `xy` from which a way to the goal is seen.
  Vec2 nearest_reached(const Vec2& xy) const;

 private:
  struct Queued {
    double key;
    std::size_t cell;
    bool operator>(const Queued& other) const { return key != other.key ? key > other.key : cell > other.cell; }
  };
  using Queue = std::priority_queue<Queued, std::vector<Queued>, std::greater<>>;

  void seed(Queue& queue);
  void relax_around(std::size_t from, Queue& queue);
  bool relax(std::size_t cell, int direction, std::size_t from);
  double reach(std::size_t from, double distance_m, double z) const;
  bool improve(std::size_t cell, int direction, int layer);
  void circle(std::size_t cell);
  double metre_cost(std::size_t cell, int layer) const;
  double straight_estimate(const Vec3& position) const;
  double value_at(std::size_t cell, double z) const;
  double lowest(std::size_t cell) const;

  const Site& site_;
  CoarseBand band_;
  double climb_slope_;
  double descent_slope_;
  std::vector<double> values_;  ///< V of (cell, layer).
  std::vector<float> offers_;   ///< U of (cell, direction, layer): the best that each neighbour has to offer.
  std::vector<char> queued_;
};

}  // namespace alate
