// Figures of a method on a map, over its seeds, and of two methods side by side over the maps.
//
// They come from the colony's own history: what the program of the paper would have shown. Under the main reading that
// is what the independent check measures; the colony of the reading "as coded" takes F over other cells, and its
// diagonals cost 1.4. Runs without a route do not count.
#pragma once

#include <functional>

#include "study/bootstrap.hpp"
#include "study/yin2021/study.hpp"

namespace alate::yin2021 {

/// What is followed over the iterations.
using Pick = std::optional<double> (*)(const GridStats&);
std::optional<double> length_of(const GridStats& stats);
std::optional<double> deviation_of(const GridStats& stats);  ///< F.
std::optional<double> turns_of(const GridStats& stats);
std::optional<double> score_of(const GridStats& stats);       ///< S of the best route.
std::optional<double> mean_score_of(const GridStats& stats);  ///< Mean S of the ants.

/// Of the best route at the end; null for runs that have no route.
const GridStats* last_stats(const StudyRun& run);

/// A figure of all runs of a method on a map; nothing where they do not give one.
using Figure = std::function<std::optional<double>(const Trial&)>;

/// Mean over the runs that have a route by `iteration`, counted from 1; runs that ended keep their last.
Figure mean_at(std::size_t iteration, Pick pick);
Figure final_mean(Pick pick);
/// Variance of the sample (n - 1) at the end; 0 where values differ by rounding alone.
Figure final_variance(Pick pick);
/// Of the run with the least S, the first of equals.
Figure of_best(Pick pick);
/// Mean number of the last iteration in which the best route's figure changed.
Figure settled(Pick pick);
/// Mean at the end less the mean at `iteration`.
Figure change_since(std::size_t iteration, Pick pick);

/// A figure of both methods on every map where both have it.
struct Pairs {
  std::vector<double> li;
  std::vector<double> yin;

  /// Yin less Li.
  std::vector<double> differences() const;
  /// The same in percent of Li; maps where Li has 0 are left out.
  std::vector<double> percent() const;
};
Pairs pairs(const Comparison& comparison, const Figure& figure);

/// Change of the variance of the length within a map, percent of the baseline's, over all maps together.
std::optional<Interval> variance_change(const Comparison& comparison);

/// Mean of a list; nothing for an empty one.
std::optional<double> mean_of(const std::vector<double>& values);

/// First iterations of both methods on the same map, where both have a route.
struct FirstIterations {
  std::size_t pairs = 0;
  std::size_t unequal = 0;      ///< Of those, with lengths that differ.
  std::size_t same_height = 0;  ///< Of those that differ, with equal F.
  std::size_t same_turns = 0;   ///< Of those that differ, with equal T.
};
/// Run i of the baseline beside run i + `shift` of the new method, counted round: 0 pairs equal seeds, which draw equal
/// random numbers; 1 pairs runs that have none in common, as those of two programs.
FirstIterations first_iterations(const Comparison& comparison, std::size_t shift);

}  // namespace alate::yin2021
