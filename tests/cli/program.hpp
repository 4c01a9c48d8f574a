// The real program, and scenarios to give it.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <nlohmann/json.hpp>

#include "support/process.hpp"

namespace alate::test {

using Json = nlohmann::json;

inline const std::string kJacksboro = ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml";
inline const std::string kCorrectionPoints = ALATE_SOURCE_DIR "/examples/corrections/scenario.yaml";
inline const std::string kJacksboroTerrain = ALATE_SOURCE_DIR "/examples/jacksboro/jacksboro.tif";

/// A small scenario without terrain, in plain metres; line 5 holds the threat.
inline const std::string kSmall =
    "frame: {local: true}\n"
    "start: {position_m: [0, 0, 100], heading_deg: 90}\n"
    "goal: {position_m: [3000, 500, 100], tolerance_m: 200}\n"
    "vehicle: {step_m: 200, roll_deg: [-10, 0, 10], pitch_deg: [-5, 0, 5], yaw_deg: [-10, 0, 10]}\n"
    "threats: [{name: radar, center_m: [1500, 250, 100], radius_m: 400, core_m: 100}]\n";

inline Command alate_command(std::vector<std::string> words, const std::string& input = "") {
  words.insert(words.begin(), ALATE_PROGRAM);
  return {.words = std::move(words), .input = input, .folder = {}};
}

inline Finished alate(std::vector<std::string> words, const std::string& input = "") {
  return run(alate_command(std::move(words), input));
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

inline void expect_contains(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in:\n" << text;
}

}  // namespace alate::test
