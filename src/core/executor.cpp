#include "alate/core/executor.hpp"

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cassert>
#include <exception>
#include <optional>

namespace alate {

namespace {

/// Pieces per thread: enough to even out unequal work, few enough to cost nothing.
constexpr std::size_t kPiecesPerThread = 8;

/// One loop: threads take pieces from a counter until none is left; after a failure the rest is taken but not run.
/// It ends with its last piece, not with its last thread: one that wakes late finds nothing left to do.
class Loop {
 public:
  Loop(std::size_t count, std::size_t threads, const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), piece_(std::max<std::size_t>(1, count / (threads * kPiecesPerThread))), body_(body) {}

  void work() {
    for (std::size_t begin = next_.fetch_add(piece_); begin < count_; begin = next_.fetch_add(piece_)) {
      const std::size_t end = std::min(begin + piece_, count_);
      if (!failed_) run(begin, end);
      if (done_.fetch_add(end - begin) + end - begin == count_) done_.notify_all();
    }
  }

  void wait() const {
    for (std::size_t done = done_; done < count_; done = done_) done_.wait(done);
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void run(std::size_t begin, std::size_t end) {
    try {
      body_(begin, end);
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }

  std::size_t count_;
  std::size_t piece_;
  const std::function<void(std::size_t, std::size_t)>& body_;  ///< Gone once all is done.
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> failed_{false};
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
  const auto loop = std::make_shared<Loop>(count, pool_->threads, body);
  const std::size_t helpers = std::min(pool_->threads, count) - 1;
  for (std::size_t i = 0; i < helpers; ++i) boost::asio::post(*pool_->workers, [loop] { loop->work(); });
  loop->work();
  loop->wait();
  loop->rethrow();
}

}  // namespace alate
