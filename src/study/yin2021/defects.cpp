#include "study/yin2021/defects.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "space/height_grid.hpp"
#include "study/yin2021/judgement.hpp"
#include "study/yin2021/summary.hpp"

namespace alate::yin2021 {

namespace {

/// Both sizes, one after the other.
template <class OnSize>
std::string on_both(OnSize on_size) {
  std::string words;
  for (const Size size : kBoth) {
    const std::string said = on_size(size);
    if (!said.empty()) words += fmt::format("{}{}: {}.", words.empty() ? "" : " ", size_name(size), said);
  }
  return words;
}

double share_percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string heights_measured(const Study& study) {
  return on_both([&](Size size) {
    const CodedHeights found = coded_heights(study, size);
    const FirstIterations coded = first_iterations(study.compare(size, reading_index(kHeightsAsCoded)), 1);
    const FirstIterations meant = first_iterations(study.compare(size), 1);
    return fmt::format(
        "{} routes of {} different numbers of cells have a 100 F from {:.2f} to {:.2f}, {} by the number of cells "
        "alone; where two first iterations differ in length, F is equal in {:.1f} % of the pairs, with F as meant in "
        "{:.1f} %",
        found.runs, found.counts, 100 * found.least, 100 * found.most, found.by_count_alone ? "told" : "not told",
        share_percent(coded.same_height, coded.unequal), share_percent(meant.same_height, meant.unequal));
  });
}

/// Do both runs tell the same of every iteration?
bool alike(const StudyRun& a, const StudyRun& b) {
  return std::ranges::equal(a.plan.history, b.plan.history, [](const IterationStats& x, const IterationStats& y) {
    return x.best == y.best && x.mean == y.mean && x.worst == y.worst;
  });
}

std::string bounds_measured(const Study& study) {
  const std::string words = on_both([&](Size size) {
    const Comparison coded = study.compare(size, reading_index(kBoundsAsCoded));
    const Comparison without = study.compare(size, reading_index(kNoBounds));
    std::size_t runs = 0;
    std::size_t same = 0;
    for (std::size_t map = 0; map < coded.maps(); ++map) {
      const auto& with_bounds = coded.li_on(map).runs;
      const auto& unbounded = without.li_on(map).runs;
      for (std::size_t run = 0; run < with_bounds.size(); ++run, ++runs)
        if (alike(with_bounds[run], unbounded[run])) ++same;
    }
    return fmt::format("{} of {} runs", same, runs);
  });
  return "Runs of the baseline that are the same in every iteration with these bounds and with none: " + words;
}

/// Both methods of one experiment.
Comparison within(const Experiment& experiment, const std::string& from, const std::string& to) {
  return {.of_li = &experiment,
          .li = method_index(experiment, from),
          .of_yin = &experiment,
          .yin = method_index(experiment, to)};
}

std::string change(const Comparison& both, const Figure& figure) {
  const auto interval = mean_interval(pairs(both, figure).percent());
  return interval ? change_words(*interval, "%") : "";
}

std::string name_of(const char* method, const char* reading) {
  return method_name(method, readings()[reading_index(reading)]);
}

std::string length_and_score(const Comparison& both) {
  const std::string length = change(both, final_mean(length_of));
  return length.empty() ? "" : fmt::format("length {}, S {}", length, change(both, final_mean(score_of)));
}

std::string pheromone_measured(const Study& study) {
  const std::string bounded =
      on_both([&](Size size) { return length_and_score(within(study.on(size).main, kNoPheromone, kLi)); });
  const std::string unbounded = on_both([&](Size size) {
    return length_and_score(within(study.on(size).readings, name_of(kLi, kAsMeant), name_of(kLi, kNoBounds)));
  });
  if (bounded.empty() || unbounded.empty()) return "";
  return fmt::format(
      "From the baseline without pheromone to the baseline with it, {} From there to the baseline without bounds, {}",
      bounded, unbounded);
}

/// 1 / mu of a cell of an open grid, from one corner to the other, a = b = 1.
double way_by(int side, int column, int row) {
  return std::hypot(column, row) + std::hypot(side - 1 - column, side - 1 - row);
}

/// Largest mu over least mu among the moves of a cell.
double mu_ratio(int side, int column, int row) {
  std::vector<double> ways;
  for (int c = std::max(0, column - 1); c <= std::min(side - 1, column + 1); ++c)
    for (int r = std::max(0, row - 1); r <= std::min(side - 1, row + 1); ++r)
      if (c != column || r != row) ways.push_back(way_by(side, c, r));
  const auto [least, most] = std::ranges::minmax(ways);
  return most / least;
}

double largest_mu_ratio(int side) {
  double largest = 1;
  for (int column = 0; column < side; ++column)
    for (int row = 0; row < side; ++row) largest = std::max(largest, mu_ratio(side, column, row));
  return largest;
}

/// Largest over least eta^beta that eqs. (1) to (4) and (12) allow for two moves of a cell.
double largest_eta_ratio(const ParamValues& values) {
  const double safety = values.number("u") * values.number("theta");
  const double mu0 = values.number("mu0");
  const double most = safety + 1 + 2 * (values.number("omega") + mu0);
  const double least = safety / GridSpace::kDirections + 1 / std::numbers::sqrt2 + 2 * mu0;
  return std::pow(most / least, static_cast<double>(values.integer("beta")));
}

std::string mu_measured(const Study& study) {
  std::string words = fmt::format(
      "The best move of a cell has at most {:.2f} times the mu of its worst on 10x10 without obstacles, and {:.2f} "
      "times on 30x30; eta^beta can differ {:.0f} times.",
      largest_mu_ratio(kSizes[kSmall]), largest_mu_ratio(kSizes[kLarge]),
      largest_eta_ratio(study.on(kLarge).trial(0, kYin).planner.parameters));
  words += " First iterations of equal seeds that give routes of one length with mu and without: ";
  return words + on_both([&](Size size) {
           const FirstIterations first = first_iterations(study.compare(size), 0);
           return fmt::format("{:.0f} %", share_percent(first.pairs - first.unequal, first.pairs));
         });
}

std::string step_measured(const Study& study) {
  const std::string words = on_both([&](Size size) -> std::string {
    const Comparison both = within(study.on(size).readings, name_of(kLi, kStepFactor), name_of(kLi, kAsMeant));
    const std::string length = change(both, final_mean(length_of));
    return length.empty() ? "" : "length " + length;
  });
  return words.empty() ? "" : "From the baseline without the term to the baseline with it, " + words;
}

std::string one_map_measured(const Study& study) {
  return on_both([&](Size size) -> std::string {
    const Pairs both = pairs(study.compare(size), final_variance(length_of));
    std::vector<double> ratios;
    for (std::size_t i = 0; i < both.li.size(); ++i)
      if (both.li[i] > 0) ratios.push_back(both.yin[i] / both.li[i]);
    const auto summary = summarize(ratios);
    if (!summary) return "";
    const auto below = std::ranges::count_if(ratios, [](double ratio) { return ratio < 0.5; });
    const auto above = std::ranges::count_if(ratios, [](double ratio) { return ratio > 2; });
    return fmt::format(
        "on single maps the ratio of the variances runs from {:.2f} to {:.2f}; on {} of {} maps it is "
        "below one half, on {} above two",
        summary->least, summary->greatest, below, ratios.size(), above);
  });
}

std::string length_measured(const Study& study) {
  return on_both([&](Size size) -> std::string {
    const auto gap = [&](const char* method) {
      const Cell cell = summarize_method(study.on(size), method).cell;
      return cell.mean ? fmt::format("{} {:.1f} %", method, 100 * (*cell.mean / cell.lower_bound - 1)) : "";
    };
    return fmt::format("above the shortest way lie {}, {}, {}, {}", gap(kLi), gap(kYin), gap(kGreedy), gap(kImproved));
  });
}

}  // namespace

CodedHeights coded_heights(const Study& study, Size size) {
  const Comparison both = study.compare(size, reading_index(kHeightsAsCoded));
  CodedHeights found;
  std::map<std::size_t, double> height_by_count;
  for (std::size_t map = 0; map < both.maps(); ++map) {
    for (const Trial* trial : {&both.li_on(map), &both.yin_on(map)}) {
      for (const StudyRun& run : trial->runs) {
        const GridStats* stats = last_stats(run);
        if (stats == nullptr) continue;
        const double height = stats->best.height_deviation_m;
        const auto [at, is_new] = height_by_count.emplace(run.plan.route.states.size(), height);
        found.by_count_alone = found.by_count_alone && (is_new || std::abs(at->second - height) < 1e-12);
        found.least = found.runs == 0 ? height : std::min(found.least, height);
        found.most = std::max(found.most, height);
        ++found.runs;
      }
    }
  }
  found.counts = height_by_count.size();
  return found;
}

std::vector<Defect> defects(const Study& study) {
  return {
      {"The height deviation is taken over the wrong cells",
       "The public program reads the first n cells of the height matrix, column by column, n being the number of cells "
       "of the route. So F tells nothing but n. The paper's own figures show lengths that differ with F that is equal "
       "at the start (claim 13): this defect can do that, true heights cannot but by accident.",
       heights_measured(study)},
      {"The bounds on pheromone seldom act, and then wipe it out",
       "Eq. (11) is coded as a test of the whole matrix. It acts only if all trails at once are beyond a bound, and "
       "then makes all of them equal.",
       bounds_measured(study)},
      {"Bounds as meant leave pheromone little to say",
       "As meant, the bounds keep all trails within 1 : 4. At the lower bound, 10, a trail loses 2 an iteration, and "
       "an "
       "ant leaves 100/S, less than 1: only moves that several ants share in every iteration rise above it.",
       pheromone_measured(study)},
      {"The new factor is nearly the same for all moves of a cell",
       "mu is one over the way from the start to the goal by way of the next cell. It changes by little from one "
       "neighbour to the next, with a = b along the straight line not at all.",
       mu_measured(study)},
      {"1/d(i,j) hardly counts in a sum", "It adds 1 or 0.71 to terms of up to 11.", step_measured(study)},
      {"One map says little about a variance",
       "The paper reports the variance over 30 runs on one map. From map to map the ratio of the two variances differs "
       "widely.",
       one_map_measured(study)},
      {"Judged by length, driven by height",
       "Ants are ranked, and leave pheromone, by S = L + 100 F + T, in which F outweighs the length. The claims are "
       "about the length.",
       length_measured(study)}};
}

}  // namespace alate::yin2021
