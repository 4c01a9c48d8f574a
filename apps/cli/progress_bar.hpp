// A one-line bar on a terminal for runs that take long.
#pragma once

#include <chrono>
#include <string>

#include "alate/core/run_context.hpp"

namespace alate::cli {

/// Draws on stderr, with the time left, once two seconds have passed, and cleans up after itself. Draws nothing if
/// stderr is no terminal.
class ProgressBar {
 public:
  /// `noun` is what an iteration is: "iteration", "run".
  explicit ProgressBar(std::string noun = "iteration");
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void draw(const Progress& progress);

 private:
  std::string line(const Progress& progress) const;

  std::string noun_;
  std::chrono::steady_clock::time_point started_;
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace alate::cli
