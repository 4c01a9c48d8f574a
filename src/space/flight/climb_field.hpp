// Cost to the goal as a function of place and altitude, for an aircraft that must climb in time: the guide of the
// interval search.
//
// The relaxed aircraft has no heading and flies between the middles of coarse cells, to sixteen neighbours. Its
// altitude is a real number between an optimistic floor and ceiling; the value of a cell is linear between samples of
// altitude. V_a(z) = min over neighbours b and z' within the slopes of c |ab| + climb (z' - z)+ + V_b(z'), with c the
// price of a metre at (a, z); within a cell altitude changes on circles. Cells are settled in Dijkstra's order by the
// least of their new values, all of these at once, and again when one gets cheaper later.
//
// It is a guide, no bound: cells are coarse, floors optimistic, sixteen directions up to 2.7 % too dear.
#pragma once

#include <array>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/coarse_band.hpp"
#include "space/flight/altitude_label.hpp"

namespace alate {

class ClimbField {
 public:
  /// For the physical objective, as far as `until`. Stops early, with what it has, when `run` says so. World must
  /// outlive this.
  ClimbField(const World& world, const SlopeLimits& slopes, RunContext& run, const std::optional<Vec3>& until = {});

  /// The same for flights the other way: to the start of its world, climbs being descents. It knows nothing yet.
  ClimbField homeward() const;

  /// Goes on as far as `until`, or everywhere. What is nearer to the goal than that is then known, and what is little
  /// farther; beyond it the field is infinite.
  void grow(RunContext& run, const std::optional<Vec3>& until = {});
  /// The same, as far as what costs no more than `cost` to the goal.
  void grow_to(RunContext& run, double cost);
  /// Is it known everywhere?
  bool is_grown() const { return queue_.empty(); }

  /// Takes over to `world`, which has `added` threats more than the world before and differs in nothing else that
  /// guides. What is nearer to the goal than any of them stays; the rest is forgotten and grows anew when asked for.
  void add_threats(const World& world, std::span<const Threat> added);

  /// Forgets all that has grown: the goal of its world is another one.
  void aim_anew();

  /// Grows no more beyond a circle.
  void confine(const Vec2& center, double radius_m);

  /// Estimated cost from `position` to the goal; infinite where no way is seen.
  double operator()(const Vec3& position) const;

 private:
  static constexpr int kLayers = CoarseBand::kLayers;
  struct Queued {
    float value;
    std::uint32_t cell;
    bool operator>(const Queued& other) const { return value != other.value ? value > other.value : cell > other.cell; }
  };
  /// Layers of a cell between which values are new.
  struct Fresh {
    int low, high;
    float cheapest;
  };
  /// From a neighbour to the cell that was settled.
  struct Step {
    int column = 0, row = 0;
    float length_m = 0;
    float climb_m = 0, descent_m = 0;  ///< At most, on the way.
  };

  void set_steps();
  void set_metre_cost(std::size_t cell);
  void forget();
  double straight(const Vec3& from) const;
  template <class Enough>
  void grow_until(RunContext& run, const Enough& enough);
  void forget_from(float least);
  bool borders_forgotten(std::size_t cell) const;
  void seed();
  void settle(std::size_t cell);
  void relax(std::size_t cell, const Step& step, std::size_t to, const Fresh& fresh);
  void circle(std::size_t cell, int layer);
  void enqueue(std::size_t cell, float value);
  void offer(std::size_t cell, int layer, float value);
  float value_at(std::size_t cell, float z) const;
  float metre_cost(std::size_t cell, int layer) const {
    return metre_cost_[cell * kLayers + static_cast<std::size_t>(layer)];
  }

  const Site* site_;
  SlopeLimits slopes_;
  Vec3 end_;
  double tolerance_m_;
  CoarseBand band_;
  float climb_weight_;
  std::array<Step, 16> steps_{};
  std::vector<float> values_, metre_cost_, floor_, layer_m_;
  std::vector<float> waiting_;       ///< The least value of each cell that its neighbours have not heard of yet.
  std::vector<std::uint8_t> fresh_;  ///< Layers of each cell of which they have not heard, a bit each.
  float worthwhile_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
};

}  // namespace alate
