#include <fmt/core.h>

#include "data/route_formats.hpp"

namespace alate {

namespace {

constexpr int kSchema = 1;

/// Reads the numbers of one group in the route.
class Group {
 public:
  Group(const Json& value, std::string field, RouteBuilder& builder)
      : value_(value), field_(std::move(field)), builder_(builder) {
    if (!value.is_null() && !value.is_object()) refuse("", "must be a group");
  }

  bool given() const { return value_.is_object(); }
  std::optional<double> optional(const char* key) const { return number_in(member(value_, key), path(key), builder_); }
  double required(const char* key) const {
    if (member(value_, key).is_null()) refuse(key, "is missing");
    return optional(key).value_or(0);
  }
  Group group(const char* key) const { return {member(value_, key), path(key), builder_}; }
  std::string path(const std::string& key) const { return key.empty() ? field_ : field_ + "." + key; }
  void refuse(const char* key, const char* message) const {
    builder_.refuse({.field = path(key), .value = shown(member(value_, key)), .message = message});
  }

 private:
  const Json& value_;
  std::string field_;
  RouteBuilder& builder_;
};

std::optional<AttitudeAction> action_of(const Group& group) {
  if (!group.given()) return std::nullopt;
  return AttitudeAction{.roll_rad = radians(group.required("roll_deg")),
                        .pitch_rad = radians(group.required("pitch_deg")),
                        .yaw_rad = radians(group.required("yaw_deg"))};
}

std::optional<ArcPlane> plane_of(const Group& group) {
  if (!group.given()) return std::nullopt;
  return ArcPlane{.center_z_m = group.required("center_z_m"),
                  .normal = {group.required("normal_x"), group.required("normal_y"), group.required("normal_z")}};
}

std::optional<Arc> arc_of(const Group& group) {
  if (!group.given()) return std::nullopt;
  return Arc{.center = {group.required("center_x_m"), group.required("center_y_m")},
             .radius_m = group.required("radius_m"),
             .angle_rad = radians(group.required("angle_deg")),
             .plane = plane_of(group.group("plane"))};
}

LegKind kind_of(const Json& state, const Group& group) {
  const Json& name = member(state, "leg");
  for (const LegKind kind : {LegKind::start, LegKind::straight, LegKind::arc, LegKind::climb}) {
    if (name == to_string(kind)) return kind;
  }
  if (!name.is_null()) group.refuse("leg", "must be start, straight, arc or climb");
  return LegKind::straight;
}

void add_state(const Json& json, const std::string& field, RouteBuilder& builder) {
  const Group group(json, field, builder);
  RouteState state{.position = Vec3::Zero(), .leg = kind_of(json, group)};
  state.arc = arc_of(group.group("arc"));
  state.action = action_of(group.group("actions"));
  state.point_id = integer_in(member(json, "point_id"), group.path("point_id"), builder);
  if (state.leg == LegKind::arc && !state.arc) group.refuse("arc", "an arc needs centre, radius and angle");
  if (state.leg != LegKind::arc && state.arc) group.refuse("leg", "must be arc where an arc is given");
  const GivenPlace place{.x_m = group.optional("x_m"),
                         .y_m = group.optional("y_m"),
                         .lat_deg = group.optional("lat"),
                         .lon_deg = group.optional("lon"),
                         .amsl_m = group.optional("z_m")};
  builder.add(place, state, {.field = field});
}

}  // namespace

void read_result_origin(const Json& result, RouteBuilder& builder) {
  const Json& scenario = member(result, "scenario");
  if (scenario.is_string()) builder.result().scenario = scenario.get<std::string>();
  if (!scenario.is_null() && !scenario.is_string()) {
    builder.refuse({.field = "scenario", .value = shown(scenario), .message = "must be a file name"});
  }
  const Json& overrides = member(result, "overrides");
  if (!overrides.is_null() && !overrides.is_array()) {
    builder.refuse({.field = "overrides", .value = shown(overrides), .message = "must be a list"});
    return;
  }
  for (const Json& entry : overrides) {
    if (entry.is_string()) {
      builder.result().overrides.push_back(entry.get<std::string>());
    } else {
      builder.refuse({.field = "overrides", .value = shown(entry), .message = "must be key.path=VALUE"});
    }
  }
}

void read_result(const Json& result, RouteBuilder& builder) {
  const Json& schema = member(result, "schema");
  if (schema != kSchema) {
    builder.refuse({.field = "schema",
                    .value = shown(schema),
                    .limit = fmt::format("{}", kSchema),
                    .message = "not a result of this version"});
  }
  read_result_origin(result, builder);
  const Json& route = member(result, "route");
  if (!route.is_array() || route.empty()) {
    builder.refuse({.field = "route", .message = "the result holds no route"});
    return;
  }
  for (std::size_t i = 0; i < route.size(); ++i) add_state(route[i], fmt::format("route.{}", i), builder);
}

}  // namespace alate
