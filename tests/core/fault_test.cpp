#include "alate/core/fault.hpp"

#include <gtest/gtest.h>

namespace alate {
namespace {

TEST(Fault, ShowsAllParts) {
  const Fault fault{.file = "a.yaml",
                    .line = 3,
                    .column = 7,
                    .field = "goal.tolerance_m",
                    .value = "-1",
                    .limit = ">= 0",
                    .unit = "m",
                    .message = "out of range"};
  EXPECT_EQ(to_string(fault), "a.yaml:3:7: goal.tolerance_m: out of range (got -1, allowed >= 0 m)");
}

TEST(Fault, LeavesOutWhatDoesNotApply) {
  EXPECT_EQ(to_string({.message = "no route"}), "no route");
  EXPECT_EQ(to_string({.file = "a.tif", .message = "has no CRS"}), "a.tif: has no CRS");
  EXPECT_EQ(to_string({.file = "a.csv", .line = 2, .message = "too short"}), "a.csv:2: too short");
  EXPECT_EQ(to_string({.line = 2, .column = 1, .message = "too short"}), "too short");
  EXPECT_EQ(to_string({.field = "seed", .value = "x", .unit = "m", .message = "bad"}), "seed: bad (got x)");
  EXPECT_EQ(to_string({.limit = "1", .message = "bad"}), "bad (allowed 1)");
}

TEST(Fault, ControlCharactersReachNoTerminal) {
  EXPECT_EQ(to_string({.value = "\x1b[2Jé\n", .message = "bad"}), "bad (got \\x1b[2Jé\\x0a)");
}

TEST(InputError, HoldsEveryFaultAndSaysThemAll) {
  const InputError error({Fault{.field = "a", .message = "bad"}, Fault{.field = "b", .message = "worse"}});
  EXPECT_EQ(error.faults().size(), 2U);
  EXPECT_STREQ(error.what(), "a: bad\nb: worse");
}

TEST(InputError, IsThrownOnlyForFaults) {
  EXPECT_NO_THROW(throw_if_any({}));
  EXPECT_THROW(throw_if_any({Fault{.message = "bad"}}), InputError);
}

}  // namespace
}  // namespace alate
