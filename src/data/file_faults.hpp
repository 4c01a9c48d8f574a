// Faults of one file, of which only the first are told one by one.
#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "alate/core/fault.hpp"
#include "data/limits.hpp"

namespace alate {

/// Appends to `faults`, which may hold those of other files. Both must outlive this.
class FileFaults {
 public:
  FileFaults(const std::string& file, std::vector<Fault>& faults)
      : file_(file), faults_(faults), earlier_(faults.size()) {}

  void add(Fault fault) {
    if (faults_.size() - earlier_ >= kMaxFaults) {
      ++untold_;
      return;
    }
    fault.file = file_;
    faults_.push_back(std::move(fault));
  }

  /// Says how many were left out, at `line` if there is one. To be called once, last; true if there was no fault.
  bool finish(int line = 0) {
    if (untold_ > 0)
      faults_.push_back({.file = file_, .line = line, .message = fmt::format("and {} more faults", untold_)});
    return faults_.size() == earlier_;
  }

 private:
  const std::string& file_;
  std::vector<Fault>& faults_;
  std::size_t earlier_;
  std::size_t untold_ = 0;
};

}  // namespace alate
