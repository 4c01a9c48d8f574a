// Points of a front, for oracles.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

namespace alate::test {

struct FrontValue {
  int corrections = 0;
  double length_m = 0;
  double probability = 1;

  bool is_as_good_as(const FrontValue& other) const {
    return corrections <= other.corrections && length_m <= other.length_m * (1 + 1e-12) &&
           probability + 1e-11 >= other.probability;
  }
};

/// What no other value is as good as, by corrections, then length.
inline std::vector<FrontValue> front_of(std::vector<FrontValue> values) {
  std::ranges::sort(values, [](const FrontValue& a, const FrontValue& b) {
    return std::tie(a.corrections, a.length_m, b.probability) < std::tie(b.corrections, b.length_m, a.probability);
  });
  std::vector<FrontValue> front;
  for (const FrontValue& value : values)
    if (std::ranges::none_of(front, [&](const FrontValue& one) { return one.is_as_good_as(value); }))
      front.push_back(value);
  return front;
}

}  // namespace alate::test
