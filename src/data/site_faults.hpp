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
  /// Adds a fault of another file, which names its own place.
  void add_found(Fault fault) { faults_.push_back(std::move(fault)); }
  bool any() const { return !faults_.empty(); }
  std::vector<Fault> take() { return std::move(faults_); }

 private:
  const Scenario& scenario_;
  std::vector<Fault> faults_;
};

}  // namespace alate
