// The processes that mpirun started together.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

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

/// Counts for all ranks together. They make it at the same time, and each waits for the others when it ends it.
class SharedCounter {
 public:
  explicit SharedCounter(const Ranks& ranks);
  ~SharedCounter();
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;

  /// 0, 1, 2, ...: each number once, whichever rank and thread asks.
  std::size_t next();

 private:
  struct Window;
  std::unique_ptr<Window> window_;  ///< Empty where one process is alone.
  std::atomic<std::size_t> own_{0};
};

}  // namespace alate::cli
