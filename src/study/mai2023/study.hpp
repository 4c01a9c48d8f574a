// All runs of the reproduction.
#pragma once

#include "study/mai2023/optimum.hpp"
#include "study/mai2023/paper.hpp"

namespace alate::mai2023 {

struct Study {
  Experiment main;                   ///< Scene by scene.
  std::vector<Experiment> readings;  ///< kAco and kMai under every reading but the first, over fewer seeds.
  std::array<LatticeOptimum, kScenes.size()> optimum;

  const Trial& trial(Scene scene, std::string_view method) const;
  /// Reading 0 is that of the main runs.
  const Trial& trial(std::size_t reading, Scene scene, std::string_view method) const;
};

/// Nothing run yet.
Study plan_study(const ReproduceOptions& options);

/// Seeds of the readings but the first; below three of the main runs there are none.
std::uint64_t reading_seeds(const ReproduceOptions& options);

}  // namespace alate::mai2023
