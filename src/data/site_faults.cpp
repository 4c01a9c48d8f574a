#include "data/site_faults.hpp"

namespace alate {

void SiteFaults::add(Fault fault) {
  const Mark mark = mark_of(scenario_, fault.field);
  fault.file = mark.file;
  fault.line = mark.line;
  fault.column = mark.column;
  faults_.push_back(std::move(fault));
}

}  // namespace alate
