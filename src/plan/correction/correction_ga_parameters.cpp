#include "plan/correction/correction_ga_parameters.hpp"

#include "plan/correction/correction_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

constexpr const char* kPaper = "Zhou et al. 2020, problem 1";
constexpr const char* kGap = "alate: Zhou et al. 2020 leave it open";

std::vector<Parameter> common_parameters() {
  return {
      {.name = "strings",
       .default_value = word("variable"),
       .choices = {"variable", "fixed"},
       .help = "Routes of any length, grown within the limits; or chromosomes of fixed length, as published.",
       .source = "fixed: Zhou et al. 2020, problem 1; variable: alate"},
      {.name = "population",
       .default_value = whole(40),
       .min = 1,
       .max = 100000,
       .help = "Individuals.",
       .source = kGap},
      {.name = "iterations",
       .default_value = whole(40),
       .min = 1,
       .max = 1e9,
       .help = "Generations where neither a budget nor a time limit is given.",
       .source = kGap},
      {.name = "w",
       .default_value = 1.0,
       .min = 0,
       .max = 1,
       .help =
           "F = w * length + (1 - w) * corrections. Where fewer corrections are preferred they come first, whatever w "
           "is.",
       .source = "Zhou et al. 2020, objective of problem 1"},
      {.name = "scaled",
       .default_value = true,
       .help = "A correction counts as many metres as the longest leg to a point; else, as printed, as one metre.",
       .source = "false: Zhou et al. 2020; true: alate"},
  };
}

std::vector<Parameter> variable_parameters() {
  return {
      {.name = "crossover",
       .default_value = 0.7,
       .min = 0,
       .max = 1,
       .help = "variable: share of children with two parents; the others are one parent, changed.",
       .source = "alate"},
      {.name = "mutation",
       .default_value = 0.3,
       .min = 0,
       .max = 1,
       .help = "variable: share of children of two parents that are changed as well.",
       .source = "alate"},
      {.name = "polish",
       .default_value = 0.5,
       .min = 0,
       .max = 1,
       .help = "variable: share of children that local search improves.",
       .source = "alate"},
      {.name = "temperature",
       .unit = "m",
       .default_value = 4000.0,
       .min = 0,
       .max = 1e9,
       .above_min = true,
       .help = "variable: a step that makes the way this much longer is e times less likely.",
       .source = "alate"},
      {.name = "spread",
       .default_value = 20.0,
       .min = 1,
       .max = 1e6,
       .help = "variable: each individual draws its temperature between this and so many times less.",
       .source = "alate"},
      {.name = "tournament",
       .default_value = whole(2),
       .min = 1,
       .max = 1000,
       .help = "variable: a parent is the best of so many drawn ones.",
       .source = "alate"},
      {.name = "step_limit",
       .unit = "points",
       .default_value = whole(1000),
       .min = 0,
       .max = 1e6,
       .help = "variable: longest route.",
       .source = "alate"},
      {.name = "step_backs",
       .default_value = whole(50),
       .min = 0,
       .max = 1e6,
       .help = "variable: a growing route takes its last step back where it meets a dead end, at most this often.",
       .source = "alate"},
  };
}

std::vector<Parameter> chromosome_parameters() {
  return {
      {.name = "genes",
       .unit = "points",
       .default_value = whole(0),
       .min = 0,
       .max = 10000,
       .help = "fixed: n, points of a chromosome; 0: two and a half times as many as the direct way needs at least.",
       .source = kGap},
      {.name = "cells",
       .default_value = whole(10),
       .min = 1,
       .max = 100000,
       .help = "fixed: m, cells of the rectangle, one after the other along the line from start to goal.",
       .source = "Zhou et al. 2020, m; not printed"},
      {.name = "rectangle_width",
       .default_value = 0.2,
       .min = 0,
       .max = 100,
       .above_min = true,
       .help = "fixed: width of the rectangle, as a share of its length.",
       .source = kGap},
      {.name = "gene_order",
       .default_value = word("along"),
       .choices = {"along", "drawn"},
       .help = "fixed: genes of the first population in order along the line, or as they were drawn.",
       .source = kGap},
      {.name = "elite",
       .default_value = whole(1),
       .min = 0,
       .max = 1000,
       .help = "fixed: so many best live on unchanged.",
       .source = kGap},
  };
}

std::vector<Parameter> rate_parameters() {
  return {
      {.name = "rates",
       .default_value = word("adaptive"),
       .choices = {"adaptive", "constant"},
       .help = "fixed: rates fall as fitness rises, or are pr1 and pm1.",
       .source = kPaper},
      {.name = "pr1",
       .default_value = 0.9,
       .min = 0,
       .max = 1,
       .help = "fixed: greatest rate of crossover.",
       .source = "Zhou et al. 2020, Pr1; the value, which is not printed, is a usual one"},
      {.name = "pr2",
       .default_value = 0.6,
       .min = 0,
       .max = 1,
       .help = "fixed: least rate of crossover.",
       .source = "Zhou et al. 2020, Pr2; the value, which is not printed, is a usual one"},
      {.name = "pm1",
       .default_value = 0.1,
       .min = 0,
       .max = 1,
       .help = "fixed: greatest rate of mutation of a gene.",
       .source = "Zhou et al. 2020, Pm1; the value, which is not printed, is a usual one"},
      {.name = "pm2",
       .default_value = 0.001,
       .min = 0,
       .max = 1,
       .help = "fixed: least rate of mutation of a gene.",
       .source = "Zhou et al. 2020, Pm2; the value, which is not printed, is a usual one"},
  };
}

std::vector<Parameter> cost_parameters() {
  return {
      {.name = "samples",
       .unit = "points",
       .default_value = whole(10),
       .min = 1,
       .max = 10000,
       .help = "fixed: samples of errors and height on each leg.",
       .source = kPaper},
      {.name = "w1",
       .default_value = 0.5,
       .min = 0,
       .max = 1,
       .help = "fixed: weight of the horizontal error in f1 = w1 g_h + w2 g_v; w2 = 1 - w1.",
       .source = kPaper},
      {.name = "error",
       .default_value = word("excess"),
       .choices = {"excess", "whole"},
       .help =
           "fixed: g is what exceeds the limit at the leg's end, or the whole error; mean over the samples of a leg.",
       .source = kGap},
      {.name = "error_metres",
       .unit = "m a unit",
       .default_value = 1e4,
       .min = 0,
       .max = 1e12,
       .help = "fixed: what a unit of error counts beside F; printed: 1.",
       .source = kGap},
      {.name = "goal_in_cost",
       .default_value = true,
       .help = "fixed: f = F + f1 + f2; else f = f1 + f2, which knows no length.",
       .source = kGap},
      {.name = "w1_altitude",
       .default_value = 1.0,
       .min = 0,
       .max = 1e12,
       .help = "fixed: w1' in f2 = w1' p1 + w2' p2, p1 the metres above the ceiling, mean over the samples of a leg.",
       .source = kPaper},
      {.name = "w2_range",
       .default_value = 1.0,
       .min = 0,
       .max = 1e12,
       .help = "fixed: w2', p2 the metres beyond the vehicle's range.",
       .source = kPaper},
  };
}

}  // namespace

std::vector<Parameter> correction_ga_parameters() {
  std::vector<Parameter> all = common_parameters();
  for (const auto& part : {variable_parameters(), window_parameters(), choice_parameters(), chromosome_parameters(),
                           rate_parameters(), cost_parameters()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<Preset> correction_ga_presets() {
  std::map<std::string, ParamValue> published{
      {"strings", word("fixed")}, {"population", whole(200)}, {"iterations", whole(500)}, {"corridor", 0.0}};
  std::map<std::string, ParamValue> plain = published;
  plain["rates"] = word("constant");
  return {
      {.name = "improved", .help = "Strings of any length, always within the limits, and local search."},
      {.name = "zhou2020", .help = "As published, with feasibility mended.", .values = std::move(published)},
      {.name = "zhou2020-plain", .help = "The same with constant rates, its baseline.", .values = std::move(plain)}};
}

}  // namespace alate
