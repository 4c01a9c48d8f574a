// Chromosomes of fixed length, as published.
//
// Source: Zhou et al. 2020, the genetic algorithm of its problem 1: correction points A, H1..Hn, B without repeats,
// genes drawn over a rectangle, fitness 1/f, adaptive rates. Departures and gaps:
// - Feasibility is that of the corrected recursion (space/navigation_error.hpp); the printed one loses the error
// carried
//   on. Chromosomes that break limits stay in the population, at the cost that f gives them; only feasible ones count
//   as routes.
// - Not printed: selection (roulette), crossover (one point; a gene that would be there twice becomes the nearest
// unused
//   point), what mutation does (the gene is drawn anew in its cell), the order of genes (along the line, or as drawn),
//   n, and that the best few live on.
#pragma once

#include "ga/adaptive_rates.hpp"
#include "ga/evolution.hpp"
#include "ga/gene_rectangle.hpp"
#include "ga/sampled_cost.hpp"

namespace alate {

struct FixedBreederOptions {
  std::size_t genes = 9;
  bool sorted = true;  ///< Genes of the first population lie in order along the line.
  AdaptiveRate crossover;
  AdaptiveRate mutation;  ///< Of each gene.
  std::size_t elite = 1;  ///< So many best live on unchanged.
};

class FixedBreeder {
 public:
  /// All must outlive this. No more genes than the rectangle has points.
  FixedBreeder(const CorrectionGraph& graph, const GeneRectangle& rectangle, const SampledCost& cost,
               FixedBreederOptions options);

  Individual first(Stream& stream, RunContext& run) const;
  Individual child(const Population& population, std::size_t slot, Stream& stream, RunContext& run) const;
  static void survive(Population& population, Population& born) { std::swap(population, born); }

 private:
  PointString crossed(const PointString& mother, const PointString& father, std::size_t cut) const;
  void mutate(PointString& genes, double rate, Stream& stream) const;
  Individual judged(PointString genes) const;

  const CorrectionGraph& graph_;
  const GeneRectangle& rectangle_;
  const SampledCost& cost_;
  FixedBreederOptions options_;
};

}  // namespace alate
