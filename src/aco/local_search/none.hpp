// No local search.
#pragma once

#include "aco/ant.hpp"
#include "alate/core/run_context.hpp"

namespace alate {

struct NoLocalSearch {
  /// Was the ant's route changed?
  template <class Space>
  bool operator()(const Space& /*space*/, Ant& /*ant*/, double /*best*/, RunContext& /*run*/) const {
    return false;
  }
};

}  // namespace alate
