#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "data/scenario_samples.hpp"

namespace alate {
namespace {

using test::kFullScenario;
using test::kGridScenario;
using test::kNavigationScenario;

/// One to four random edits: bytes replaced, removed, doubled, or pieces put in that YAML gives a meaning.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kPieces{
      "[",  "]",     "{",     "}", ": ", "- ",          "&a ",  "*a", "!!str ", "\"",    "'",   "|\n",     ">\n",
      "? ", "---\n", "...\n", "#", "\t", "%YAML 9.9\n", "<<: ", "~",  "null",   "-.inf", "0x1", "\\u0000", "\xff"};
  for (unsigned edits = random() % 4 + 1; edits > 0 && !text.empty(); --edits) {
    const std::size_t at = random() % text.size();
    const std::size_t length = random() % 20;
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), length));
        break;
      case 3:
        text.insert(at, kPieces[random() % kPieces.size()]);
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

/// Anything but InputError fails the test; what is accepted must read back.
void read_or_refuse(const std::string& text, const std::vector<std::string>& overrides) {
  try {
    const Scenario scenario = parse_scenario(text, "s.yaml", overrides);
    EXPECT_EQ(parse_scenario(to_yaml(scenario), "s.yaml"), scenario) << text;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.faults().empty()) << text;
    for (const Fault& fault : error.faults()) EXPECT_FALSE(fault.message.empty()) << text;
  }
}

TEST(ScenarioFuzz, MutatedFilesAreReadOrRefused) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) read_or_refuse(mutated(kFullScenario, random), {});
  for (int i = 0; i < 3000; ++i) read_or_refuse(mutated(kNavigationScenario, random), {});
  for (int i = 0; i < 3000; ++i) read_or_refuse(mutated(kGridScenario, random), {});
}

TEST(ScenarioFuzz, MutatedOverridesAreReadOrRefused) {
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i) read_or_refuse(kFullScenario, {mutated("threats.1={lat: 1, radius_m: 5}", random)});
}

TEST(ScenarioFuzz, EndlessRepetitionEndsSoon) {
  for (const char* piece :
       {"[",   "{",    "- ", "? ",  "a: ",    "- - ", "&a ", "!a ", "*a ", "'",     "\"", "{a: ", "[a, ", "- a\n",
        "\n ", "# \n", ",",  "a\n", "--- \n", "?\n",  ": ",  "|\n", "{,",  "- [\n", "!",  "&",    "%a\n"}) {
    for (const std::string start : {"", "threats: [", "vehicle: {"}) {
      std::string text = start;
      while (text.size() < 1'000'000) text += piece;
      const auto begin = std::chrono::steady_clock::now();
      EXPECT_THROW(parse_scenario(text, "s.yaml"), InputError) << piece;
      EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << start << piece;
    }
  }
}

}  // namespace
}  // namespace alate
