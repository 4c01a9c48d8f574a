#include <fmt/core.h>

#include "data/mission_item.hpp"
#include "data/route_formats.hpp"

namespace alate {

namespace {

constexpr int kPlanVersion = 1;
constexpr int kMissionVersion = 2;
constexpr std::size_t kParams = 7;

void require(const Json& value, const Json& wanted, const std::string& field, RouteBuilder& builder) {
  if (value == wanted) return;
  builder.refuse(
      {.field = field, .value = shown(value), .limit = shown(wanted), .message = "not a plan that alate can read"});
}

std::optional<double> home_height(const Json& mission, RouteBuilder& builder) {
  const Json& home = member(mission, "plannedHomePosition");
  if (!home.is_array() || home.size() < 3) return std::nullopt;
  return number_in(home[2], "mission.plannedHomePosition.2", builder);
}

void add_item(const Json& json, const std::string& field, MissionReader& reader, RouteBuilder& builder) {
  const Json& params = member(json, "params");
  const auto command = integer_in(member(json, "command"), field + ".command", builder);
  const auto frame = integer_in(member(json, "frame"), field + ".frame", builder);
  if (!command || !frame || !params.is_array() || params.size() != kParams) {
    builder.refuse({.field = field, .message = "a simple item needs command, frame and seven params"});
    return;
  }
  const auto param = [&](std::size_t i) {
    return number_in(params[i], fmt::format("{}.params.{}", field, i), builder);
  };
  reader.add({.command = *command, .frame = *frame, .lat_deg = param(4), .lon_deg = param(5), .height_m = param(6)},
             {.field = field});
}

}  // namespace

void read_plan(const Json& plan, RouteBuilder& builder) {
  require(member(plan, "fileType"), "Plan", "fileType", builder);
  require(member(plan, "version"), kPlanVersion, "version", builder);
  const Json& mission = member(plan, "mission");
  if (!mission.is_object()) {
    builder.refuse({.field = "mission", .message = "the plan holds no mission"});
    return;
  }
  require(member(mission, "version"), kMissionVersion, "mission.version", builder);
  const Json& items = member(mission, "items");
  if (!items.is_array()) {
    builder.refuse({.field = "mission.items", .value = shown(items), .message = "must be a list of items"});
    return;
  }
  MissionReader reader(builder, home_height(mission, builder));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string field = fmt::format("mission.items.{}", i);
    if (member(items[i], "type") == "SimpleItem") {
      add_item(items[i], field, reader, builder);
    } else if (member(items[i], "type") == "ComplexItem") {
      builder.note(fmt::format("{} is a complex item ({}) and was passed over", field,
                               shown(member(items[i], "complexItemType"))));
    } else {
      builder.refuse({.field = field + ".type", .limit = "SimpleItem or ComplexItem", .message = "unknown item"});
    }
  }
  reader.finish();
}

}  // namespace alate
