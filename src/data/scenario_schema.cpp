#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "alate/data/scenario_file.hpp"
#include "data/scenario_fields.hpp"

namespace alate {

namespace {

using Json = nlohmann::ordered_json;

Json schema_of(const Description& description);

Json number_schema(const Range& range) {
  Json json{{"type", "number"}};
  json[range.open ? "exclusiveMinimum" : "minimum"] = range.min;
  json[range.open && range.max < kMaxMagnitude ? "exclusiveMaximum" : "maximum"] = range.max;
  return json;
}

// The type of a field and its default, if the fresh struct holds one.
Json schema_of(const Text& slot) {
  Json json{{"type", "string"}};
  if (slot.use != Text::Use::label) json["minLength"] = 1;
  if (slot.value) json["default"] = *slot.value;
  return json;
}
Json schema_of(const Flag& slot) { return {{"type", "boolean"}, {"default", slot.value}}; }
Json schema_of(const Number& slot) {
  Json json = number_schema(slot.range);
  if (slot.whole) json["type"] = "integer";
  if (slot.value) json["default"] = *slot.value;
  return json;
}
Json schema_of(const Numbers& slot) {
  Json item = number_schema(slot.range);
  if (slot.whole) item["type"] = "integer";
  return {{"type", "array"}, {"items", item}, {"minItems", slot.least()}, {"maxItems", slot.most()}};
}
Json schema_of(const Choice& slot) { return {{"enum", slot.words}, {"default", slot.words[slot.value]}}; }
Json schema_of(const Group& slot) { return schema_of(slot.open()); }
Json schema_of(const Groups& slot) {
  return {{"type", "array"}, {"items", schema_of(slot.at(0))}, {"minItems", slot.least}, {"maxItems", kMaxListItems}};
}
Json schema_of(const FileOrGroups& slot) {
  return {{"anyOf", Json::array({schema_of(slot.file), schema_of(slot.items)})}};
}
Json schema_of(const Words& /*slot*/) {
  return {{"type", "object"}, {"additionalProperties", {{"type", {"string", "number", "boolean"}}}}};
}

/// One object a set of keys: all of them, and none of the other sets'.
Json schema_of(const std::vector<std::vector<std::string>>& one_of) {
  Json json = Json::array();
  for (const auto& keys : one_of) {
    Json forbidden = Json::object();
    for (const auto& other : one_of)
      for (const std::string& key : other) forbidden[key] = false;
    for (const std::string& key : keys) forbidden.erase(key);
    json.push_back({{"required", keys}, {"properties", forbidden}});
  }
  return json;
}

/// One "this key or that" for each field that another makes needless.
Json required_or_replaced(const Description& description) {
  Json choices = Json::array();
  for (const Field& field : description.fields) {
    if (!field.required || field.unless.empty()) continue;
    choices.push_back({{"anyOf", {{{"required", {field.key}}}, {{"required", {field.unless}}}}}});
  }
  return choices;
}

Json schema_of(const Description& description) {
  Json json{{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
  for (const Field& field : description.fields) {
    Json property = std::visit([](const auto& slot) { return schema_of(slot); }, field.slot);
    property["description"] = field.unit.empty() ? field.help : fmt::format("{} ({})", field.help, field.unit);
    if (field.required) {
      property.erase("default");
      if (field.unless.empty()) json["required"].push_back(field.key);
    }
    json["properties"][field.key] = std::move(property);
  }
  if (const Json choices = required_or_replaced(description); !choices.empty()) json["allOf"] = choices;
  if (!description.one_of.empty()) json["oneOf"] = schema_of(description.one_of);
  return json;
}

}  // namespace

std::string scenario_json_schema() {
  Scenario fresh;
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "alate scenario"}};
  json.update(schema_of(describe(fresh)));
  return json.dump(2) + "\n";
}

}  // namespace alate
