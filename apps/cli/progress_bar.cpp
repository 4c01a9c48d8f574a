#include "progress_bar.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace alate::cli {

namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 2s;
constexpr int kWidth = 30;

std::string line(const Progress& progress) {
  std::string text;
  if (progress.fraction > 0) {
    const auto filled = static_cast<std::size_t>(std::lround(progress.fraction * kWidth));
    text = fmt::format("[{:<{}}] {:3.0f} %  ", std::string(filled, '#'), kWidth, 100 * progress.fraction);
  }
  text += fmt::format("iteration {}", progress.iteration);
  if (progress.best) text += fmt::format(", best cost {:.1f}", *progress.best);
  return text;
}

}  // namespace

ProgressBar::ProgressBar()
    : shown_from_(std::chrono::steady_clock::now() + kPatience), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void ProgressBar::draw(const Progress& progress) {
  if (!terminal_ || std::chrono::steady_clock::now() < shown_from_) return;
  drawn_ = true;
  std::fputs(("\r\x1b[K" + line(progress)).c_str(), stderr);
}

}  // namespace alate::cli
