#include <cmath>
#include <nlohmann/json.hpp>

#include "alate/study/reproduce.hpp"

namespace alate {

namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(); }

Json claim_json(const Claim& claim) {
  Json by_case = Json::object();
  for (const auto& [name, value] : claim.by_case) by_case[name] = number(value);
  return {{"id", claim.id},
          {"text", claim.text},
          {"published", number(claim.published)},
          {"ours", number(claim.ours)},
          {"unit", claim.unit},
          {"verdict", to_string(claim.verdict)},
          {"why", claim.why},
          {"ours_by_case", by_case}};
}

Json cell_json(const Cell& cell) {
  return {{"case", cell.case_name},       {"method", cell.method},       {"runs", cell.runs},
          {"found", cell.found},          {"mean", number(cell.mean)},   {"sd", number(cell.sd)},
          {"best", number(cell.best)},    {"worst", number(cell.worst)}, {"lower_bound", number(cell.lower_bound)},
          {"wall_s", number(cell.wall_s)}};
}

Json cells_json(const std::vector<Cell>& cells) {
  Json all = Json::array();
  for (const Cell& cell : cells) all.push_back(cell_json(cell));
  return all;
}

Json setting_json(const ParamValue& setting) {
  return std::visit([](const auto& value) { return Json(value); }, setting);
}

}  // namespace

std::string to_json(const Reproduction& reproduction) {
  Json claims = Json::array();
  for (const Claim& claim : reproduction.claims) claims.push_back(claim_json(claim));
  Json defects = Json::array();
  for (const Defect& defect : reproduction.defects)
    defects.push_back({{"title", defect.title}, {"text", defect.text}, {"measured", defect.measured}});
  Json settings = Json::object();
  for (const auto& [name, value] : reproduction.settings) settings[name] = setting_json(value);
  const Json json{{"paper", reproduction.paper},
                  {"notes", reproduction.notes},
                  {"claims", claims},
                  {"cells", cells_json(reproduction.cells)},
                  {"details", cells_json(reproduction.details)},
                  {"defects", defects},
                  {"settings", settings}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace alate
