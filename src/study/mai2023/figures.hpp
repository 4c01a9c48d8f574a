// Figures of runs: the four measures of the paper, and how both methods compare by them.
#pragma once

#include <string>
#include <vector>

#include "study/bootstrap.hpp"
#include "study/mai2023/study.hpp"

namespace alate::mai2023 {

/// Index of what runs are measured by.
using Measure = std::size_t;
inline constexpr Measure kFitness = 0;
inline constexpr Measure kLength = 1;
inline constexpr Measure kIteration = 2;
inline constexpr Measure kTime = 3;
inline constexpr std::array<Measure, 4> kMeasures{kFitness, kLength, kIteration, kTime};

struct MeasureWords {
  const char* id;
  const char* name;
  const char* unit;  ///< Of changes: "%" or the measure's own.
  int decimals;
};
const MeasureWords& words_of(Measure measure);

/// Nothing for a run without a route that passed. Fitness is as the colony ranks; of colonies that look for short
/// routes it is F of their route, cut by planes. Length in km, time in ms.
std::optional<double> figure(const Trial& trial, const StudyRun& run, Measure measure);

/// Of the runs that have one, by seed.
std::vector<double> figures(const Trial& trial, Measure measure);

std::optional<Summary> summary_of(const Trial& trial, Measure measure);

/// Mean of a colony's best fitness after `iteration`, from 1, over the runs that have a route by then; a run that ended
/// keeps its last.
std::optional<double> fitness_after(const Trial& trial, std::size_t iteration);

/// From the first to the second, with its 95 % interval over the runs, taken by seed: of the means, in percent; of
/// iterations, their difference.
std::optional<Interval> change(const Trial& from, const Trial& to, Measure measure);

/// The mean fitness of a method, percent above the least that the lattice allows.
std::optional<double> gap_percent(const Study& study, Scene scene, std::string_view method);

/// First iteration at which the mean of the best fitness is no higher than `fitness`; nothing if it never is.
std::optional<std::size_t> reaches(const Trial& trial, double fitness);

}  // namespace alate::mai2023
