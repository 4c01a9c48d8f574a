// All runs of the reproduction.
#pragma once

#include "study/yin2021/maps.hpp"

namespace alate::yin2021 {

/// Both methods under one reading on the maps of one size.
struct Comparison {
  const Experiment* of_li = nullptr;
  std::size_t li = 0;  ///< Index of the method.
  const Experiment* of_yin = nullptr;
  std::size_t yin = 0;

  std::size_t maps() const { return of_li->cases.size(); }
  const Trial& li_on(std::size_t map) const { return of_li->at(map, li); }
  const Trial& yin_on(std::size_t map) const { return of_yin->at(map, yin); }
};

struct SizeStudy {
  Maps maps;            ///< Its cases are those of both experiments.
  Experiment main;      ///< As meant, and baselines.
  Experiment readings;  ///< Both methods under every reading, over fewer seeds.

  /// Runs of a method of either experiment.
  const Trial& trial(std::size_t map, std::string_view method) const;
};

struct Study {
  std::array<SizeStudy, kSizes.size()> sizes;

  const SizeStudy& on(Size size) const { return sizes[size]; }
  /// The main reading, 0, over all seeds; every other over as few as it has, on both sides.
  Comparison compare(Size size, std::size_t reading) const;
  Comparison compare(Size size) const { return compare(size, 0); }
};

/// Nothing run yet.
Study plan_study(const ReproduceOptions& options, std::size_t maps = kMaps);

/// Seeds of the readings but the main one.
std::uint64_t reading_seeds(const ReproduceOptions& options);

}  // namespace alate::yin2021
