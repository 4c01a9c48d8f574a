// Local search on strings of correction points.
//
// A window is a stretch of the string. What lies inside is replaced by nothing, or by up to a few points, so that
// removing, inserting, replacing and exchanging neighbours are all the same move. The best change of each window is
// made at once, windows from start to goal, until a whole round changes nothing.
//
// Source: alate; windows after Or 1976 and Lin, Kernighan 1973, with the part outside the window held fixed. Errors
// after a window come from `Trip::room`, so a change is judged without flying the rest. Points that would make the
// window longer than it was are never looked at.
#pragma once

#include "alate/core/run_context.hpp"
#include "space/point_string.hpp"
#include "space/successors.hpp"

namespace alate {

struct WindowOptions {
  std::size_t most_old = 3;  ///< Points that a window may lose,
  std::size_t most_new = 2;  ///< and gain.
};

class StringWindows {
 public:
  /// All must outlive this.
  StringWindows(const CorrectionGraph& graph, const Successors& successors, const RoutePrice& price,
                const WindowOptions& options)
      : graph_(graph), successors_(successors), price_(price), options_(options) {}

  /// Improves a string that keeps all limits; was it changed? Polls `run` at every window.
  bool improve(PointString& points, RunContext& run) const;

 private:
  const CorrectionGraph& graph_;
  const Successors& successors_;
  RoutePrice price_;
  WindowOptions options_;
};

}  // namespace alate
