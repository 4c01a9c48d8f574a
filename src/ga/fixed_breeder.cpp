#include "ga/fixed_breeder.hpp"

#include <numeric>

namespace alate {

namespace {

double fitness(const Individual& one) {
  constexpr double kLeastCost = 1e-12;
  return 1 / std::max(one.cost, kLeastCost);
}

FitnessStats fitness_stats(const Population& population) {
  FitnessStats stats;
  for (const Individual& one : population) {
    stats.mean += fitness(one);
    stats.most = std::max(stats.most, fitness(one));
  }
  stats.mean /= static_cast<double>(population.size());
  return stats;
}

/// The individual of the given rank by cost, equals in the order of the population.
const Individual& ranked(const Population& population, std::size_t rank) {
  std::vector<std::size_t> order(population.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::nth_element(order, order.begin() + static_cast<std::ptrdiff_t>(rank), {},
                           [&](std::size_t i) { return std::pair(population[i].cost, i); });
  return population[order[rank]];
}

/// Drawn in proportion to fitness.
const Individual& parent(const Population& population, Stream& stream) {
  double sum = 0;
  for (const Individual& one : population) sum += fitness(one);
  double left = stream.uniform() * sum;
  for (const Individual& one : population) {
    left -= fitness(one);
    if (left < 0) return one;
  }
  return population.back();
}

}  // namespace

FixedBreeder::FixedBreeder(const CorrectionGraph& graph, const GeneRectangle& rectangle, const SampledCost& cost,
                           FixedBreederOptions options)
    : graph_(graph), rectangle_(rectangle), cost_(cost), options_(options) {
  options_.genes = std::min(options_.genes, rectangle.points());
}

Individual FixedBreeder::first(Stream& stream, RunContext& /*run*/) const {
  std::vector<GeneRectangle::Coordinate> drawn;
  for (std::size_t g = 0; g < options_.genes; ++g) drawn.push_back(rectangle_.draw(stream));
  if (options_.sorted) std::ranges::stable_sort(drawn, {}, &GeneRectangle::Coordinate::along_m);
  PointString genes;
  for (const auto& place : drawn) genes.push_back(rectangle_.nearest_unused(place, genes));
  return judged(std::move(genes));
}

Individual FixedBreeder::child(const Population& population, std::size_t slot, Stream& stream,
                               RunContext& /*run*/) const {
  if (slot < std::min(options_.elite, population.size())) return ranked(population, slot);
  const FitnessStats stats = fitness_stats(population);
  const Individual& mother = parent(population, stream);
  const Individual& father = parent(population, stream);
  Individual child = mother;
  const double better = std::max(fitness(mother), fitness(father));
  if (options_.genes > 0 && stream.uniform() < options_.crossover(better, stats))
    child = judged(crossed(mother.genes, father.genes, stream.below(options_.genes + 1)));
  mutate(child.genes, options_.mutation(fitness(child), stats), stream);
  return judged(std::move(child.genes));
}

PointString FixedBreeder::crossed(const PointString& mother, const PointString& father, std::size_t cut) const {
  PointString genes(mother.begin(), mother.begin() + static_cast<std::ptrdiff_t>(cut));
  for (std::size_t g = cut; g < father.size(); ++g) {
    const bool repeated = std::ranges::find(genes, father[g]) != genes.end();
    genes.push_back(repeated ? rectangle_.nearest_unused(rectangle_.at(father[g]), genes) : father[g]);
  }
  return genes;
}

void FixedBreeder::mutate(PointString& genes, double rate, Stream& stream) const {
  for (std::size_t g = 0; g < genes.size(); ++g) {
    if (stream.uniform() >= rate || genes.size() >= rectangle_.points()) continue;
    const std::size_t cell = rectangle_.cell_of(rectangle_.at(genes[g]));
    genes[g] = rectangle_.nearest_unused(rectangle_.draw_in(cell, stream), genes);
  }
}

Individual FixedBreeder::judged(PointString genes) const {
  const Trip trip = fly(graph_, genes);
  Individual one{.genes = std::move(genes), .cost = cost_(graph_, trip)};
  const bool in_range = !cost_.range_m || trip.length_m <= *cost_.range_m;
  if (in_range && trip.keeps_limits && is_free(graph_, trip))
    one.price = cost_.goal.of(trip.length_m, trip.corrections());
  return one;
}

}  // namespace alate
