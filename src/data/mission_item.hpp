// MAVLink mission items, as .plan and .waypoints files hold them.
#pragma once

#include <optional>
#include <set>

#include "data/route_builder.hpp"

namespace alate {

/// One item: command and frame are MAV_CMD and MAV_FRAME (mavlink.io, common message set).
struct MissionItem {
  int command = 0;
  int frame = 0;
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  std::optional<double> height_m;
};

/// Adds the items that an aircraft flies to, in order: waypoints, loiters, take-offs and landings. Heights above
/// home are raised by its height; heights above terrain are faults. Items without a place, and those at latitude and
/// longitude 0 ("here" for autopilots), are passed over and counted in a note.
class MissionReader {
 public:
  explicit MissionReader(RouteBuilder& builder, std::optional<double> home_m) : builder_(builder), home_m_(home_m) {}

  void add(const MissionItem& item, const Origin& origin);
  /// Writes the notes.
  void finish();

 private:
  std::optional<double> height_above_sea(const MissionItem& item, const Origin& origin);

  RouteBuilder& builder_;
  std::optional<double> home_m_;
  std::set<int> passed_commands_;
  int passed_ = 0;
  int here_ = 0;
  int loiters_ = 0;
};

}  // namespace alate
