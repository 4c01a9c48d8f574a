// Ctrl-C and SIGTERM as a request to stop, so that the best route so far is checked and written.
#pragma once

#include <stop_token>
#include <thread>

namespace alate::cli {

/// While it lives, the first signal requests a stop and the second ends the program at once (exit 130).
/// Make it before any other thread: threads inherit the blocked signals, and one thread of ours waits for them.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  bool requested() const { return stop_.stop_requested(); }

 private:
  std::stop_source stop_;
  std::jthread waiter_;
};

}  // namespace alate::cli
