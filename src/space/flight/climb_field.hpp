// Cost to the goal as a function of place and altitude, for an aircraft that must climb in time: the guide of the
// interval search.
//
// The relaxed aircraft has no heading and flies between the middles of coarse cells, to sixteen neighbours. Its
// altitude is a real number between an optimistic floor and ceiling; the value of a cell is linear between samples of
// altitude. V_a(z) = min over neighbours b and z' within the slopes of c |ab| + climb (z' - z)+ + V_b(z'), with c the
// price of a metre at (a, z); within a cell altitude changes on circles. Dijkstra's order over samples; a sample that
// gets cheaper later is looked at again.
//
// It is a guide, no bound: cells are coarse, floors optimistic, sixteen directions up to 2.7 % too dear.
#pragma once

#include <array>
#include <queue>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/coarse_band.hpp"
#include "space/flight/altitude_label.hpp"

namespace alate {

class ClimbField {
 public:
  /// For the physical objective. Stops early, with what it has, when `run` says so.
  ClimbField(const World& world, const SlopeLimits& slopes, RunContext& run);

  /// Estimated cost from `position` to the goal; infinite where no way is seen.
  double operator()(const Vec3& position) const;

 private:
  static constexpr int kLayers = CoarseBand::kLayers;
  struct Queued {
    float value;
    std::uint32_t sample;
    bool operator>(const Queued& other) const {
      return value != other.value ? value > other.value : sample > other.sample;
    }
  };
  /// From a neighbour to the cell that was settled.
  struct Step {
    int column = 0, row = 0;
    float length_m = 0;
    float climb_m = 0, descent_m = 0;  ///< At most, on the way.
  };

  void seed();
  void settle(std::uint32_t sample);
  void relax(std::size_t cell, const Step& step, std::size_t to, int layer);
  void circle(std::size_t cell, int layer);
  void offer(std::size_t cell, int layer, float value);
  float value_at(std::size_t cell, float z) const;
  float metre_cost(std::size_t cell, int layer) const {
    return metre_cost_[cell * kLayers + static_cast<std::size_t>(layer)];
  }

  const Site& site_;
  SlopeLimits slopes_;
  CoarseBand band_;
  float climb_weight_;
  std::array<Step, 16> steps_{};
  std::vector<float> values_, metre_cost_, floor_, layer_m_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
};

}  // namespace alate
