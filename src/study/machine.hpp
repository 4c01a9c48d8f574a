// What the runs were made on, so that times can be judged.
#pragma once

#include <string>

namespace alate {

struct Machine {
  std::string processor;  ///< Model name as the kernel tells it; "unknown" where it does not.
  unsigned cores = 0;     ///< Hardware threads; 0 if unknown.
  std::string compiler;
};

Machine this_machine();

}  // namespace alate
