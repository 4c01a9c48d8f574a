#include "study/zhou2020/paper.hpp"

#include <fmt/core.h>

#include "alate/data/scenario_file.hpp"

namespace alate::zhou2020 {

namespace {

/// alpha1, alpha2, beta1, beta2 and theta of a set.
struct SetLimits {
  std::array<double, 2> alpha;
  std::array<double, 2> beta;
  double theta;
};

constexpr std::array<SetLimits, kSets> kLimits{
    {{.alpha = {25, 15}, .beta = {20, 25}, .theta = 30}, {.alpha = {20, 10}, .beta = {15, 20}, .theta = 20}}};

const std::vector<int> kTable2{504, 295, 124, 76, 34, 12, 404, 595, 398};
const std::vector<int> kTable3{346, 200, 294, 136, 108, 74, 462, 543, 369, 457, 388, 436};

PublishedRoute table_2(int id_offset) {
  return {.id = id_offset == 0 ? "table-2" : "table-2-off-by-one",
          .source = id_offset == 0 ? "Zhou 2020, table 2" : "Zhou 2020, table 2, every id one higher",
          .task = Task::straight,
          .set = 0,
          .length_m = 16972.695304,
          .rounding_m = 5e-7,
          .corrections = 9,
          .probability = {},
          .points = kTable2,
          .id_offset = id_offset};
}

/// A row of table 5. Only the best one's route is printed, as table 3.
PublishedRoute table_5(const char* id, const char* method, double length_m, int corrections) {
  return {.id = id,
          .source = fmt::format("Zhou 2020, table 5, {}", method),
          .task = Task::turning,
          .set = 0,
          .length_m = length_m,
          .rounding_m = 5e-7,
          .corrections = corrections,
          .probability = {},
          .points = {},
          .method = method};
}

std::vector<PublishedRoute> of_zhou() {
  return {table_2(0),
          table_2(1),
          {.id = "table-3",
           .source = "Zhou 2020, table 3",
           .task = Task::turning,
           .set = 0,
           .length_m = 14957.842315,
           .rounding_m = 5e-7,
           .corrections = 12,
           .probability = {},
           .points = kTable3},
          table_5("table-5-plain-1", "plain A*, weights 1", 35436.632176, 31),
          table_5("table-5-plain-2", "plain A*, weights 2", 41258.581392, 39),
          table_5("table-5-improved-1", "improved A*, weights 1", 14957.842315, 12),
          table_5("table-5-improved-2", "improved A*, weights 2", 19513.452647, 15)};
}

std::vector<PublishedRoute> of_the_contest() {
  return {
      {.id = "prize-1",
       .source = "contest, first prize",
       .task = Task::straight,
       .set = 0,
       .length_m = 104898,
       .rounding_m = 0.5,
       .corrections = 8,
       .probability = {},
       .points = {503, 69, 237, 155, 338, 457, 555, 436}},
      {.id = "prize-2",
       .source = "contest, first prize",
       .task = Task::straight,
       .set = 1,
       .length_m = 109342,
       .rounding_m = 0.5,
       .corrections = 12,
       .probability = {},
       .points = {163, 114, 8, 309, 305, 123, 45, 160, 92, 93, 61, 292}},
      {.id = "dijkstra-ants-1",
       .source = "contest, improved Dijkstra and ant colony",
       .task = Task::unreliable,
       .set = 0,
       .length_m = 105770,
       .rounding_m = 5,
       .corrections = 9,
       .probability = 1,
       .points = {503, 294, 91, 607, 61, 250, 369, 566, 400}},
      {.id = "dijkstra-ants-2",
       .source = "contest, improved Dijkstra and ant colony",
       .task = Task::unreliable,
       .set = 1,
       .length_m = 155070,
       .rounding_m = 5,
       .corrections = 21,
       .probability = 1,
       .points = {140, 226, 288, 306, 237, 280, 65, 142, 310, 7, 145, 293, 156, 213, 164, 50, 247, 38, 110, 99, 292}}};
}

std::vector<PublishedRoute> of_route_planning() {
  const std::string source = "QPromise/Route-Planning, A* and greedy";
  return {{.id = "greedy-astar-1",
           .source = source,
           .task = Task::straight,
           .set = 0,
           .length_m = 108436.66,
           .rounding_m = 0.005,
           .corrections = 10,
           .probability = {},
           .points = {521, 64, 80, 237, 282, 33, 11, 403, 594, 501}},
          {.id = "greedy-astar-2",
           .source = source,
           .task = Task::straight,
           .set = 1,
           .length_m = 109265.60,
           .rounding_m = 0.005,
           .corrections = 10,
           .probability = {},
           .points = {105, 188, 309, 305, 123, 49, 160, 92, 93, 61}},
          {.id = "greedy-astar-turning",
           .source = source,
           .task = Task::turning,
           .set = 0,
           .length_m = 109030.78,
           .rounding_m = 0.005,
           .corrections = 10,
           .probability = {},
           .points = {503, 200, 136, 80, 237, 278, 375, 172, 340, 277}},
          {.id = "greedy-astar-unreliable",
           .source = source,
           .task = Task::unreliable,
           .set = 0,
           .length_m = 112367.50,
           .rounding_m = 0.005,
           .corrections = 11,
           .probability = 0.96,
           .points = {503, 200, 136, 80, 237, 278, 375, 172, 340, 277, 370}}};
}

std::vector<PublishedRoute> without_routes() {
  const std::string niu = "Niu 2025";
  const std::string industry = "J. Math. Industry 10:26 (2020)";
  return {{.id = "niu-1",
           .source = niu,
           .task = Task::straight,
           .set = 0,
           .length_m = 106802.676,
           .rounding_m = 5e-4,
           .corrections = {},
           .probability = {},
           .points = {}},
          {.id = "niu-2",
           .source = niu,
           .task = Task::straight,
           .set = 1,
           .length_m = 118730.036,
           .rounding_m = 5e-4,
           .corrections = {},
           .probability = {},
           .points = {}},
          {.id = "industry-1",
           .source = industry,
           .task = Task::turning,
           .set = 0,
           .length_m = 124610,
           .rounding_m = 5,
           .corrections = 11,
           .probability = {},
           .points = {}},
          {.id = "industry-2",
           .source = industry,
           .task = Task::turning,
           .set = 1,
           .length_m = 110000,
           .rounding_m = 5,
           .corrections = 12,
           .probability = {},
           .points = {}}};
}

}  // namespace

int number_of(Task task) { return static_cast<int>(task) + 1; }

const std::vector<PublishedRoute>& published_routes() {
  static const std::vector<PublishedRoute> kAll = [] {
    std::vector<PublishedRoute> all = of_zhou();
    for (const auto& rows : {of_the_contest(), of_route_planning(), without_routes()})
      all.insert(all.end(), rows.begin(), rows.end());
    return all;
  }();
  return kAll;
}

std::string set_name(std::size_t set) { return fmt::format("set {}", set + 1); }

std::string case_name(std::size_t set, Task task) {
  return fmt::format("{}, problem {}", set_name(set), number_of(task));
}

Scenario scenario_of(std::size_t set, Task task, const std::string& file) {
  const SetLimits& limits = kLimits.at(set);
  Scenario scenario;
  scenario.file = "reproduce";
  scenario.objective.climb = 0;
  NavigationSpec& navigation = scenario.navigation.emplace();
  navigation.points_file = file;
  navigation.alpha = limits.alpha;
  navigation.beta = limits.beta;
  navigation.theta = limits.theta;
  // In problems 1 and 2 every correction works.
  if (task != Task::unreliable) navigation.success = 1;
  if (task == Task::turning) {
    navigation.turn_radius_m = 200;
    navigation.turn_model = TurnModel::arc_tangent;
  }
  return scenario;
}

}  // namespace alate::zhou2020
