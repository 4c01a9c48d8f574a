#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "commands.hpp"

namespace alate::cli {

namespace {

/// Sent to our own waiting thread when it is no longer needed.
constexpr int kWake = SIGUSR1;

sigset_t signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int each : {SIGINT, SIGTERM, kWake}) sigaddset(&set, each);
  return set;
}

void wait_for_signals(const std::stop_token& ending, std::stop_source& stop) {
  const sigset_t set = signals();
  while (true) {
    int received = 0;
    if (sigwait(&set, &received) != 0) return;
    if (ending.stop_requested()) return;
    if (received == kWake) continue;
    if (!stop.request_stop()) _exit(kInterrupted);
  }
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::jthread([this](const std::stop_token& ending) { wait_for_signals(ending, stop_); });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  pthread_kill(waiter_.native_handle(), kWake);
}

}  // namespace alate::cli
