#include "data/route_builder.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "data/limits.hpp"

namespace alate {

namespace {

constexpr double kSameFrame = 1;  ///< Metres.

struct Range {
  const char* name;
  std::optional<double> GivenPlace::* member;
  double limit;
  const char* unit;
};

constexpr std::array<Range, 5> kRanges{{{"x_m", &GivenPlace::x_m, kMaxMagnitude, "m"},
                                        {"y_m", &GivenPlace::y_m, kMaxMagnitude, "m"},
                                        {"lat", &GivenPlace::lat_deg, 90, "deg"},
                                        {"lon", &GivenPlace::lon_deg, 180, "deg"},
                                        {"height", &GivenPlace::amsl_m, kMaxMagnitude, "m"}}};

std::string joined(const std::string& field, const std::string& name) {
  return field.empty() ? name : field + "." + name;
}

}  // namespace

RouteBuilder::RouteBuilder(Frame frame, std::string file, std::string format)
    : frame_(std::move(frame)), file_(std::move(file)) {
  result_.format = std::move(format);
}

void RouteBuilder::refuse(Fault fault) {
  fault.file = file_;
  if (faults_.size() < kMaxFaults) {
    faults_.push_back(std::move(fault));
  } else {
    ++uncounted_;
  }
}

void RouteBuilder::note(std::string text) { result_.notes.push_back(std::move(text)); }

bool RouteBuilder::in_range(const GivenPlace& place, const Origin& origin) {
  bool good = true;
  for (const Range& range : kRanges) {
    const auto& value = place.*range.member;
    if (!value || std::abs(*value) <= range.limit) continue;
    good = false;
    refuse({.line = origin.line,
            .field = joined(origin.field, range.name),
            .value = fmt::format("{}", *value),
            .limit = fmt::format("{} to {}", -range.limit, range.limit),
            .unit = range.unit,
            .message = "out of range"});
  }
  return good;
}

std::optional<Vec2> RouteBuilder::planar_position(const GivenPlace& place, const Origin& origin) {
  std::optional<Vec2> metric;
  if (place.x_m && place.y_m) metric = Vec2(*place.x_m, *place.y_m);
  const bool geo = place.lat_deg && place.lon_deg;
  if (!geo || (frame_.is_local() && metric)) {
    if (!metric) refuse({.line = origin.line, .field = origin.field, .message = "no position"});
    return metric;
  }
  auto projected = frame_.from_geo({*place.lat_deg, *place.lon_deg});
  if (!projected) {
    refuse({.line = origin.line,
            .field = origin.field,
            .value = fmt::format("{}, {}", *place.lat_deg, *place.lon_deg),
            .message =
                fmt::format("this latitude and longitude have no place in the scenario's frame ({})", frame_.name())});
    return std::nullopt;
  }
  if (metric && (*metric - *projected).norm() <= kSameFrame) return metric;
  other_frame_ = other_frame_ || metric;
  return projected;
}

void RouteBuilder::add(const GivenPlace& place, RouteState state, const Origin& origin) {
  if (++seen_ > kMaxRouteStates || !in_range(place, origin)) return;
  const auto xy = planar_position(place, origin);
  if (!place.amsl_m) {
    refuse({.line = origin.line, .field = origin.field, .message = "no height above mean sea level"});
  }
  if (!xy || !place.amsl_m) return;
  state.position = {xy->x(), xy->y(), *place.amsl_m};
  if (result_.route.empty()) {
    state.leg = LegKind::start;
    state.arc.reset();
    state.action.reset();
  }
  result_.route.states.push_back(std::move(state));
}

RouteFile RouteBuilder::finish() {
  if (seen_ > kMaxRouteStates) {
    refuse({.value = fmt::format("{}", seen_),
            .limit = fmt::format("<= {}", kMaxRouteStates),
            .message = "too many positions"});
  } else if (seen_ < 2 && faults_.empty()) {
    refuse({.value = fmt::format("{}", seen_), .limit = ">= 2", .message = "too few positions for a route"});
  }
  if (other_frame_) note("positions were taken from lat and lon: x_m and y_m belong to another frame");
  return finish_origin();
}

RouteFile RouteBuilder::finish_origin() {
  if (uncounted_ > 0) faults_.push_back({.file = file_, .message = fmt::format("{} more faults", uncounted_)});
  throw_if_any(std::move(faults_));
  return std::move(result_);
}

}  // namespace alate
