// A one-line bar on a terminal for runs that take long.
#pragma once

#include <chrono>

#include "alate/core/run_context.hpp"

namespace alate::cli {

/// Draws on stderr once two seconds have passed, and cleans up after itself. Draws nothing if stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void draw(const Progress& progress);

 private:
  std::chrono::steady_clock::time_point shown_from_;
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace alate::cli
