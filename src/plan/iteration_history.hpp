// What histories of colonies tell.
#pragma once

#include <cstdint>
#include <vector>

#include "alate/world/problem.hpp"

namespace alate {

/// The iteration, from 1, that changed the best so far last; 0 if none found anything.
inline std::uint64_t last_change(const std::vector<IterationStats>& history) {
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history[i].best_so_far && (i == 0 || history[i].best_so_far != history[i - 1].best_so_far)) last = i + 1;
  return last;
}

}  // namespace alate
