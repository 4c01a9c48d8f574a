#include "core/number_text.hpp"

#include <gtest/gtest.h>

namespace alate {
namespace {

TEST(ParseNumber, ReadsDecimalNumbers) {
  const std::vector<std::pair<const char*, double>> numbers{
      {"0", 0}, {"-0.5", -0.5}, {"+2", 2}, {".5", 0.5}, {"5.", 5}, {"1e3", 1000}, {"-1.5E-2", -0.015}, {"0.10", 0.1}};
  for (const auto& [text, value] : numbers) {
    EXPECT_EQ(parse_number(text).problem, "") << text;
    EXPECT_EQ(parse_number(text).value, value) << text;
  }
}

TEST(ParseNumber, RefusesAllElseAndSaysWhy) {
  for (const char* text : {"", "-", "+", "x", "1x", "--1", "+-1", "1 ", " 1", "1_000", "1,5", "1:30", "e5", "."})
    EXPECT_EQ(parse_number(text).problem, "must be a number") << text;
  for (const char* text : {"nan", ".nan", ".NaN", "inf", "-.inf", "+Infinity"})
    EXPECT_EQ(parse_number(text).problem, "must be finite") << text;
  for (const char* text : {"010", "-007", "00", "01.5", "0x10", "0o7", "0b1"})
    EXPECT_EQ(parse_number(text).problem, "must be a decimal number without leading zeros") << text;
  for (const char* text : {"1e999", "-1e-999"})
    EXPECT_EQ(parse_number(text).problem, "is too large or too small for a number") << text;
}

}  // namespace
}  // namespace alate
