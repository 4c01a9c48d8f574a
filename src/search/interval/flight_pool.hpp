// Ways that are bettered by turns: the best of them every other round, the second best every fourth, and so on.
#pragma once

#include <vector>

#include "search/interval/flight_path.hpp"

namespace alate {

class FlightPool {
 public:
  /// `trials`: changes tried a round. Of ways nearer to each other than `apart_m` all along only the better is kept.
  FlightPool(int trials, double apart_m) : trials_(trials), apart_m_(apart_m) {}

  bool empty() const { return paths_.empty(); }
  std::size_t size() const { return paths_.size(); }
  /// The cheapest, as far as is known before altitudes are chosen.
  const FlightPath& best() const { return paths_.front(); }

  /// Takes a way in, unless it is none or much like a better one.
  void add(FlightPath path);
  /// Shortens it and betters it for a round before.
  void add_bettered(FlightPath path, Stream& random, RunContext& run);
  /// A round on one of the ways.
  void better(Stream& random, RunContext& run);

 private:
  static constexpr std::size_t kMost = 8;

  bool alike(const Track& a, const Track& b) const;
  void sort();

  int trials_;
  double apart_m_;
  std::vector<FlightPath> paths_;
  std::uint64_t rounds_ = 0;
};

}  // namespace alate
