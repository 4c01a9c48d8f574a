#include "study/matrix/record.hpp"

#include <nlohmann/json.hpp>

namespace alate {

using Json = nlohmann::json;

StudyRecord record_of(const StudyRun& run) {
  StudyRecord record{.outcome = run.plan.outcome,
                     .valid = run.passed,
                     .cost = run.metrics.cost,
                     .length_m = run.metrics.length_m,
                     .grid = run.metrics.grid,
                     .lower_bound = run.plan.lower_bound,
                     .wall_s = run.wall_s,
                     .iterations = run.plan.history.size()};
  for (std::size_t i = 0; i < run.plan.history.size(); ++i) {
    const auto& best = run.plan.history[i].best_so_far;
    if (best && (record.improvements.empty() || *best < record.improvements.back().second))
      record.improvements.emplace_back(i + 1, *best);
  }
  return record;
}

Json to_json_value(const StudyRecord& record) {
  Json json{{"outcome", static_cast<int>(record.outcome)},
            {"valid", record.valid},
            {"cost", record.cost},
            {"length_m", record.length_m},
            {"lower_bound", record.lower_bound},
            {"wall_s", record.wall_s},
            {"iterations", record.iterations},
            {"improvements", record.improvements}};
  if (const auto& grid = record.grid) json["grid"] = {grid->length_cells, grid->height_deviation_m, grid->turns};
  return json;
}

StudyRecord record_from(const Json& json) {
  StudyRecord record;
  record.outcome = static_cast<Outcome>(json.at("outcome").get<int>());
  json.at("valid").get_to(record.valid);
  json.at("cost").get_to(record.cost);
  json.at("length_m").get_to(record.length_m);
  json.at("lower_bound").get_to(record.lower_bound);
  json.at("wall_s").get_to(record.wall_s);
  json.at("iterations").get_to(record.iterations);
  json.at("improvements").get_to(record.improvements);
  if (const auto grid = json.find("grid"); grid != json.end())
    record.grid = {.length_cells = grid->at(0), .height_deviation_m = grid->at(1), .turns = grid->at(2)};
  return record;
}

}  // namespace alate
