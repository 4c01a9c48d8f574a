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

/// "40 s", "3 min", "2.5 h".
std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  return seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

ProgressBar::ProgressBar(std::string noun)
    : noun_(std::move(noun)), started_(std::chrono::steady_clock::now()), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

std::string ProgressBar::line(const Progress& progress) const {
  std::string text;
  if (progress.fraction > 0) {
    const auto filled = static_cast<std::size_t>(std::lround(progress.fraction * kWidth));
    text = fmt::format("[{:<{}}] {:3.0f} %  ", std::string(filled, '#'), kWidth, 100 * progress.fraction);
  }
  text += fmt::format("{} {}", noun_, progress.iteration);
  if (progress.best) text += fmt::format(", best cost {:.1f}", *progress.best);
  if (progress.fraction <= 0) return text;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
  return text + fmt::format(", {} left", duration_text(spent.count() * (1 / progress.fraction - 1)));
}

void ProgressBar::draw(const Progress& progress) {
  if (!terminal_ || std::chrono::steady_clock::now() < started_ + kPatience) return;
  drawn_ = true;
  std::fputs(("\r\x1b[K" + line(progress)).c_str(), stderr);
}

}  // namespace alate::cli
