// The genetic algorithm: one loop for fixed and for variable strings. What individuals are, how they are born and who
// lives on is the breeder's.
//
// Cost: individuals an iteration times what the breeder does for one. Determinism: individual a of an iteration draws
// from Stream(seed, iteration, a) and writes slot a; the population changes between births only. The same bits for any
// number of threads.
#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <vector>

#include "alate/core/run_context.hpp"
#include "alate/core/stream.hpp"
#include "alate/world/problem.hpp"
#include "space/point_string.hpp"

namespace alate {

struct Individual {
  PointString genes;
  double cost = std::numeric_limits<double>::infinity();   ///< What selection sees; infinite: nothing was born.
  double price = std::numeric_limits<double>::infinity();  ///< F of a feasible route; infinite unless it is one.

  bool feasible() const { return price < std::numeric_limits<double>::infinity(); }
};

using Population = std::vector<Individual>;

template <class B>
concept Breeder = requires(const B& breeder, const Population& population, Population& changing, Stream& stream,
                           std::size_t slot, RunContext& run) {
  { breeder.first(stream, run) } -> std::same_as<Individual>;
  { breeder.child(population, slot, stream, run) } -> std::same_as<Individual>;
  /// Who lives on: `changing` takes what it wants of the children.
  { breeder.survive(changing, changing) };
};

/// Costs of those that are feasible routes.
inline IterationStats stats_of(const Population& population, const Individual& best) {
  IterationStats stats;
  double sum = 0;
  std::size_t feasible = 0;
  for (const Individual& one : population) {
    if (!one.feasible()) continue;
    ++feasible;
    sum += one.price;
    stats.best = std::min(stats.best.value_or(one.price), one.price);
    stats.worst = std::max(stats.worst.value_or(one.price), one.price);
  }
  if (best.feasible()) stats.best_so_far = best.price;
  if (feasible != 0) stats.mean = sum / static_cast<double>(feasible);
  stats.arrived = static_cast<double>(feasible) / static_cast<double>(population.size());
  return stats;
}

struct EvolutionOptions {
  std::size_t population = 100;
  std::uint64_t iterations =
      100;  ///< Where neither a budget nor a time limit is given. The first is the first population.
};

struct Evolved {
  Individual best;  ///< Of all iterations; not feasible if none was.
  std::vector<IterationStats> history;
};

template <Breeder B>
Evolved evolve(const B& breeder, const EvolutionOptions& options, RunContext& run) {
  Evolved result;
  Population population;
  Population born(options.population);
  while (run.start_iteration(options.iterations)) {
    run.executor().for_ranges(born.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t a = begin; a < end; ++a) {
        Stream stream(run.seed(), run.iterations(), a);
        if (run.keep_going())
          born[a] = population.empty() ? breeder.first(stream, run) : breeder.child(population, a, stream, run);
      }
    });
    for (const Individual& one : born)
      if (one.price < result.best.price) result.best = one;
    if (population.empty()) {
      population = born;
    } else {
      breeder.survive(population, born);
    }
    result.history.push_back(stats_of(population, result.best));
    run.report(result.best.feasible() ? std::optional(result.best.price) : std::nullopt);
  }
  return result;
}

}  // namespace alate
