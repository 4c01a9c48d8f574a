// The processes that mpirun started together.
#pragma once

#include <cstddef>

namespace alate::cli {

/// MPI where the environment says that mpirun started this process and alate was built with it; else one process
/// alone. Starting MPI costs time, so nothing else starts it. Make it after Interrupt: MPI has threads of its own.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  std::size_t rank() const { return rank_; }
  std::size_t count() const { return count_; }
  bool first() const { return rank_ == 0; }

  /// Waits for all ranks; true if every one of them says true.
  bool all(bool mine) const;
  /// Ends every rank at once with this exit code, where there are several.
  void abort(int code) const;

 private:
  bool started_ = false;
  std::size_t rank_ = 0;
  std::size_t count_ = 1;
};

}  // namespace alate::cli
