// Weights of choices and the draw.
#include "aco/weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

constexpr std::size_t kCount = 125;

Choices some_choices() {
  Choices choices;
  choices.resize(kCount);
  Stream stream(5, 0, 0);
  for (std::size_t k = 0; k < choices.cost.size(); ++k) {
    const bool counts = k < kCount && k % 7 != 0;
    choices.cost[k] = counts ? 1 + 20 * static_cast<float>(stream.uniform()) : std::numeric_limits<float>::infinity();
    choices.guide[k] = 30 * static_cast<float>(stream.uniform());
    choices.trail[k] = static_cast<float>(stream.uniform());
  }
  return choices;
}

TEST(Weights, PowerIsInProportionToOneOverJToTheBeta) {
  Choices choices = some_choices();
  weigh_by_power(3, choices);
  for (std::size_t k = 2; k < kCount; ++k) {
    const auto ratio = static_cast<double>(choices.cost[1] / choices.cost[k]);
    const double expected = k % 7 == 0 ? 0 : std::pow(ratio, 3) * static_cast<double>(choices.weight[1]);
    EXPECT_NEAR(choices.weight[k], expected, 1e-5 * expected);
  }
}

TEST(Weights, GoalDirectedIsTheExponentialOfWhatIsDearerThanTheBest) {
  for (const float scale : {0.05F, 0.7F, 30.0F}) {
    Choices choices = some_choices();
    weigh_by_goal(scale, choices);
    double least = kInfinity;
    for (std::size_t k = 0; k < kCount; ++k)
      least = std::min(least, static_cast<double>(choices.cost[k] + choices.guide[k]));
    for (std::size_t k = 0; k < kCount; ++k) {
      const double above = static_cast<double>(choices.cost[k] + choices.guide[k]) - least;
      const double expected = std::exp(-above / static_cast<double>(scale));
      EXPECT_NEAR(choices.weight[k], expected, 1e-4 * expected + 1e-25) << k;
    }
  }
}

TEST(Weights, NothingInKGivesNoWeightAndNoDraw) {
  Choices choices = some_choices();
  std::ranges::fill(choices.cost, std::numeric_limits<float>::infinity());
  weigh_by_goal(1, choices);
  EXPECT_EQ(draw(choices.weight, 0.5), choices.weight.size());
  weigh_by_power(3, choices);
  EXPECT_EQ(draw(choices.weight, 0.5), choices.weight.size());
  EXPECT_EQ(heaviest(choices.weight), choices.weight.size());
}

TEST(Weights, TheTrailMultipliesAlphaTimes) {
  Choices choices = some_choices();
  weigh_by_power(0, choices);
  multiply_by_trail(TrailLevels({}), 2, choices);  // new levels are as stored
  for (std::size_t k = 1; k < 7; ++k) EXPECT_FLOAT_EQ(choices.weight[k], choices.trail[k] * choices.trail[k]);
}

TEST(Draw, FollowsTheWeights) {
  Choices choices = some_choices();
  weigh_by_power(1, choices);
  double total = 0;
  for (const float weight : choices.weight) total += static_cast<double>(weight);
  std::vector<int> drawn(choices.weight.size());
  constexpr int kDraws = 200000;
  Stream stream(9, 0, 0);
  for (int i = 0; i < kDraws; ++i) ++drawn[draw(choices.weight, stream.uniform())];
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const double expected = kDraws * static_cast<double>(choices.weight[k]) / total;
    EXPECT_NEAR(drawn[k], expected, 6 * std::sqrt(expected) + 1e-9) << k;
  }
}

TEST(Draw, NeverTakesWhatHasNoWeight) {
  AlignedFloats weights(128, 0.0F);
  weights[77] = 1e-20F;
  for (const double uniform : {0.0, 0.3, 1 - 0x1.0p-53}) EXPECT_EQ(draw(weights, uniform), 77U);
  EXPECT_EQ(heaviest(weights), 77U);
}

}  // namespace
}  // namespace alate
