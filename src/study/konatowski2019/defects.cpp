#include "study/konatowski2019/defects.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "space/rotations.hpp"
#include "study/intrusion.hpp"

namespace alate::konatowski2019 {

namespace {

/// Sum over the nodes of the distance to the goal, with `cuts` nodes a leg.
double distance_sum(const Route& route, const Vec3& goal, int cuts) {
  double sum = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i)
    for (int cut = 1; cut <= cuts; ++cut) sum += (route.segment(i).at(static_cast<double>(cut) / cuts) - goal).norm();
  return sum;
}

const Mission& mission(const Study& study) { return study.open.cases.front().site().mission; }

std::string fuel_measured(const Study& study) {
  const Route* route = study.base_route();
  if (route == nullptr) return "";
  const Vec3& goal = mission(study).goal;
  const double whole = distance_sum(*route, goal, 1);
  const double halved = distance_sum(*route, goal, 2);
  return fmt::format(
      "The cheapest route without threats has a sum of {:.2f} with nodes every 2 units. The same line with "
      "nodes every 1 has {:.2f}, {:.2f} times as much.",
      whole, halved, halved / whole);
}

std::string detour_measured(const Study& study) {
  const Route* route = study.base_route();
  if (route == nullptr) return "";
  const auto to_go = [&](const RouteState& state) { return (state.position - mission(study).goal).norm(); };
  const double first = to_go(route->states[1]);
  const double late = to_go(route->states[route->states.size() - 2]);
  return fmt::format(
      "On the same route the first leg costs {:.2f} and the last but one {:.2f}, though both are 2 units long: {:.0f} "
      "times as much.",
      first, late, first / late);
}

/// Mean of one field of the history over all runs of a method on all cases, at one iteration.
template <class Field>
double history_mean(const Study& study, std::string_view method, std::size_t iteration, Field field) {
  double sum = 0;
  std::size_t count = 0;
  const std::size_t m = method_index(study.main, method);
  for (std::size_t c = 0; c < study.main.cases.size(); ++c) {
    for (const StudyRun& run : study.main.at(c, m).runs) {
      if (iteration >= run.plan.history.size()) continue;
      sum += std::optional<double>(run.plan.history[iteration].*field).value_or(0);
      ++count;
    }
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

std::size_t iterations_of(const Study& study) { return study.trial(0, 0, kLiteral).runs.front().plan.history.size(); }

std::string arrivals_measured(const Study& study) {
  const std::size_t last = iterations_of(study);
  if (last == 0) return "";
  return fmt::format(
      "With 50 ants {:.2f} % of them arrive in the first iteration and {:.1f} % in the last, mean over all "
      "cases and seeds.",
      100 * history_mean(study, kLiteral, 0, &IterationStats::arrived),
      100 * history_mean(study, kLiteral, last - 1, &IterationStats::arrived));
}

std::string visit_measured() {
  std::string parts;
  for (const Published& row : kPublished)
    parts +=
        fmt::format("{}{:.2f} at {:.2f}", parts.empty() ? "" : ", ", 1 - kEvaporation + kDeposit / row.best, row.best);
  return fmt::format(
      "After one visit and one evaporation a node holds 1 - rho + Q/J, at the three printed best costs {}. An "
      "unknown node holds 1.",
      parts);
}

std::string known_measured(const Study& study) {
  const std::size_t last = iterations_of(study);
  if (last == 0) return "";
  const auto share = [&](std::size_t i) { return 100 * history_mean(study, kLiteral, i, &IterationStats::known); };
  std::size_t locked = 0;
  while (locked < last && share(locked) < 50) ++locked;
  const std::string lock = locked < last
                               ? fmt::format("More than half of the moves do so from iteration {} on", locked + 1)
                               : "It never comes to half of the moves";
  return fmt::format(
      "With 50 ants {:.2f} % of the moves of the tenth iteration meet a node that an earlier one had left, and "
      "{:.1f} % of the last. {}.",
      share(std::min<std::size_t>(9, last - 1)), share(last - 1), lock);
}

std::string memory_measured(const Study& study) {
  const Duel result = duel(study, kNoPheromone, kLiteral);
  if (result.cells == 0) return "";
  return fmt::format(
      "The same number of walks without any pheromone has the lower mean cost in {} of {} cells; over all "
      "cells it is {:.2f} % {}.",
      result.won, result.cells, std::abs(result.saving_percent), result.saving_percent >= 0 ? "lower" : "higher");
}

/// Of the best routes, the sphere that is entered deepest between nodes, unseen by the cost.
std::string between_nodes_measured(const Study& study) {
  double most = 0;
  std::string where;
  for (std::size_t c = 0; c < study.main.cases.size(); ++c) {
    const Trial* trial = study.main.best_trial(c);
    if (trial == nullptr) continue;
    for (const Threat& threat : study.main.cases[c].site().threats) {
      const Intrusion depth = deepest_intrusion(threat, trial->best()->plan.route);
      const double unseen = std::max(0.0, depth.along_legs) - std::max(0.0, depth.at_nodes);
      if (unseen <= most) continue;
      most = unseen;
      where = fmt::format(": {} in case {}, {:.2f} deep at the nodes and {:.2f} between them", threat.name,
                          study.main.cases[c].name, std::max(0.0, depth.at_nodes), depth.along_legs);
    }
  }
  return fmt::format("On our best routes the deepest point between two nodes lies up to {:.2f} deeper than any node{}.",
                     most, where);
}

std::string directions_measured(const Study& study) {
  const RotationSet rotations(study.open.cases.front().site().vehicle);
  std::size_t ahead = 0;
  for (std::size_t k = 0; k < rotations.size(); ++k)
    if (rotations.forward_x()[k] > 1 - 1e-12) ++ahead;
  return fmt::format("{} of the {} actions lead straight ahead, to one and the same node.", ahead, rotations.size());
}

}  // namespace

std::vector<Defect> defects(const Study& study) {
  return {
      {"What is called fuel is neither fuel nor length",
       "It is the distance to go, summed over nodes. It grows with the square of the distance, and doubles when the "
       "step is "
       "halved though the flight is the same.",
       fuel_measured(study)},
      {"A detour is dear near the start and cheap near the target",
       "Each node pays for its distance to the target, so the same extra leg has another price in another place.",
       detour_measured(study)},
      {"Nothing in the cost makes an ant arrive",
       "Tolerance and step limit are part of the problem, and the paper states neither. Here: one step, and 40 steps.",
       arrivals_measured(study)},
      {"One visit makes a node less attractive than an unknown one",
       "Unknown nodes keep a pheromone of 1 for ever, known ones lose four fifths an iteration. Nodes of ants that "
       "never "
       "arrive fade to nothing: in effect a list of what to avoid.",
       visit_measured()},
      {"A trail is hardly ever met again",
       "Pheromone lies on exact points, and walks from one start soon have no point in common.", known_measured(study)},
      {"The memory of the colony does not pay", "What is learnt on points that do not recur cannot lead.",
       memory_measured(study)},
      {"Pheromone forgets the attitude",
       "A node is a point, but what can follow depends on how the aircraft lies there. Two ants on one point may have "
       "no next "
       "node in common.",
       ""},
      {"Straight ahead is counted five times",
       "Without pitch and yaw every roll leads to the same point, so that one node is drawn with five times its "
       "weight.",
       directions_measured(study)},
      {"Threats are felt at nodes only", "Between two nodes a route may cut through a sphere at no cost.",
       between_nodes_measured(study)},
  };
}

}  // namespace alate::konatowski2019
