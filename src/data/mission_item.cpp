#include "data/mission_item.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace alate {

namespace {

// MAV_CMD_NAV_*: waypoint, loiters (unlimited, turns, time, to altitude), land, take-off, spline waypoint, VTOL
// take-off and landing.
const std::set<int> kFlownTo{16, 17, 18, 19, 21, 22, 31, 82, 84, 85};
const std::set<int> kLoiters{17, 18, 19, 31};

bool above_sea(int frame) { return frame == 0 || frame == 5; }
bool above_home(int frame) { return frame == 3 || frame == 6; }
bool above_terrain(int frame) { return frame == 10 || frame == 11; }

}  // namespace

std::optional<double> MissionReader::height_above_sea(const MissionItem& item, const Origin& origin) {
  const auto refuse = [&](const char* message) {
    builder_.refuse({.line = origin.line,
                     .field = origin.field.empty() ? "frame" : origin.field + ".frame",
                     .value = fmt::format("{}", item.frame),
                     .limit = "0, 3, 5 or 6",
                     .message = message});
    return std::nullopt;
  };
  if (above_terrain(item.frame)) return refuse("heights above terrain cannot be judged; give them above sea level");
  if (above_home(item.frame) && !home_m_) return refuse("height above home, but the file gives no height of home");
  if (above_home(item.frame) && item.height_m) return *item.height_m + *home_m_;
  if (above_home(item.frame) || above_sea(item.frame)) return item.height_m;
  return refuse("unknown frame of a position");
}

void MissionReader::add(const MissionItem& item, const Origin& origin) {
  if (!kFlownTo.contains(item.command)) {
    passed_commands_.insert(item.command);
    ++passed_;
    return;
  }
  if (item.lat_deg.value_or(0) == 0 && item.lon_deg.value_or(0) == 0) {
    ++here_;
    return;
  }
  if (kLoiters.contains(item.command)) ++loiters_;
  const auto height = height_above_sea(item, origin);
  const bool known = above_sea(item.frame) || (above_home(item.frame) && home_m_);
  if (!known) return;
  builder_.add({.lat_deg = item.lat_deg, .lon_deg = item.lon_deg, .amsl_m = height}, {}, origin);
}

void MissionReader::finish() {
  if (passed_ > 0) {
    builder_.note(fmt::format("{} item(s) that are flown to nowhere were passed over (commands {})", passed_,
                              fmt::join(passed_commands_, ", ")));
  }
  if (here_ > 0) builder_.note(fmt::format("{} item(s) without latitude and longitude were passed over", here_));
  if (loiters_ > 0) {
    builder_.note(fmt::format("{} loiter(s) count as points: their circles are not judged", loiters_));
  }
}

}  // namespace alate
