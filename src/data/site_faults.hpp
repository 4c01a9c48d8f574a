// Faults found in a scenario after it was read, each with the place where its field stood.
#pragma once

#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/core/scenario.hpp"

namespace alate {

class SiteFaults {
 public:
  explicit SiteFaults(const Scenario& scenario) : scenario_(scenario) {}

  /// Adds `fault` after filling in file, line and column of its field.
  void add(Fault fault);
  bool any() const { return !faults_.empty(); }
  std::vector<Fault> take() { return std::move(faults_); }

 private:
  const Scenario& scenario_;
  std::vector<Fault> faults_;
};

}  // namespace alate
