#include "alate/core/executor.hpp"

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cassert>
#include <exception>
#include <latch>
#include <mutex>
#include <optional>

namespace alate {

namespace {

/// Pieces per thread: enough to even out unequal work, few enough to cost nothing.
constexpr std::size_t kPiecesPerThread = 8;

/// One loop: threads take pieces from a counter until none is left or one has failed.
class Loop {
 public:
  Loop(std::size_t count, std::size_t threads, const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), piece_(std::max<std::size_t>(1, count / (threads * kPiecesPerThread))), body_(body) {}

  void work() {
    try {
      for (std::size_t begin = next_.fetch_add(piece_); begin < count_; begin = next_.fetch_add(piece_)) {
        body_(begin, std::min(begin + piece_, count_));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      next_ = count_;
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  std::size_t piece_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

struct Executor::Pool {
  explicit Pool(std::size_t count) : threads(count) {
    if (count > 1) workers.emplace(count - 1);
  }
  std::size_t threads;
  std::optional<boost::asio::thread_pool> workers;
};

Executor::Executor(int threads) : pool_(std::make_unique<Pool>(static_cast<std::size_t>(threads))) {
  assert(threads >= 1);
}

Executor::~Executor() = default;

int Executor::threads() const { return static_cast<int>(pool_->threads); }

void Executor::for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (!pool_->workers || count == 1) {
    body(0, count);
    return;
  }
  Loop loop(count, pool_->threads, body);
  const std::size_t helpers = std::min(pool_->threads, count) - 1;
  std::latch done(static_cast<std::ptrdiff_t>(helpers));
  for (std::size_t i = 0; i < helpers; ++i) {
    boost::asio::post(*pool_->workers, [&] {
      loop.work();
      done.count_down();
    });
  }
  loop.work();
  done.wait();
  loop.rethrow();
}

}  // namespace alate
