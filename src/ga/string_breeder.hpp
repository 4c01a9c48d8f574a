// Routes as strings of any length, always feasible: a string is grown through the graph step by step, within the limits
// of the errors, until it can join what is left of a parent.
//
// Source: alate. Nothing here searches exactly: choices of a step are drawn by e^(-(leg + relaxed rest) / temperature),
// and local search changes windows of a few points (search/string_windows.hpp).
#pragma once

#include "ga/evolution.hpp"
#include "search/string_windows.hpp"
#include "space/successors.hpp"

namespace alate {

struct StringBreederOptions {
  double crossover = 0.7;       ///< Share of children with two parents; the others are their parent, changed.
  double mutation = 0.3;        ///< Share of children of two parents that are changed as well.
  double polish = 0.5;          ///< Share of children that local search improves.
  double temperature_m = 4000;  ///< A choice that is this much longer is e times less likely,
  double spread = 20;           ///< or up to so many times less: it is drawn for each individual.
  std::size_t tournament = 2;
  std::size_t step_limit = 100;  ///< Most points of a string.
  std::size_t step_backs = 50;   ///< Out of dead ends, while growing one string.
};

class StringBreeder {
 public:
  /// All must outlive this.
  StringBreeder(const CorrectionGraph& graph, const RelaxedToGo& to_go, const Successors& successors,
                const StringWindows& windows, const RoutePrice& price, const StringBreederOptions& options)
      : graph_(graph), to_go_(to_go), successors_(successors), windows_(windows), price_(price), options_(options) {}

  Individual first(Stream& stream, RunContext& run) const;
  Individual child(const Population& population, std::size_t slot, Stream& stream, RunContext& run) const;
  /// The cheapest of old and new, each route once.
  static void survive(Population& population, Population& born);

  /// Repair: keeps the first `kept` points of `head`, then at least `fresh` drawn ones, then goes over to `tail` at its
  /// node `from` or later, as soon as a leg leads there with which the rest of the tail can be flown. Nothing where
  /// only dead ends were met. `head` and `tail` are strings that keep all limits.
  struct Graft {
    const Trip& head;
    std::size_t kept = 0;
    const Trip& tail;
    std::size_t from = 1;
    std::size_t fresh = 0;
  };
  std::optional<PointString> grow(const Graft& graft, Stream& stream, RunContext& run) const;

 private:
  class Growth;
  const Individual& parent(const Population& population, Stream& stream) const;
  std::optional<PointString> changed(const PointString& genes, Stream& stream, RunContext& run) const;
  Individual born(std::optional<PointString> genes, bool polished, RunContext& run) const;

  const CorrectionGraph& graph_;
  const RelaxedToGo& to_go_;
  const Successors& successors_;
  const StringWindows& windows_;
  RoutePrice price_;
  StringBreederOptions options_;
};

}  // namespace alate
