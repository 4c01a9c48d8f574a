// The only owner of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace alate {

/// Runs loops over a fixed number of threads (the caller is one of them).
class Executor {
 public:
  /// `threads` >= 1; with 1 everything runs in the caller.
  explicit Executor(int threads = 1);
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  int threads() const;

  /// Calls `body(begin, end)` on pieces that cover [0, count) and returns when all are done. Which thread
  /// runs which piece is not fixed: results are the same for any number of threads only if index i writes
  /// slot i. The first exception thrown by a piece is rethrown here.
  void for_ranges(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& body);

 private:
  struct Pool;
  std::unique_ptr<Pool> pool_;
};

}  // namespace alate
