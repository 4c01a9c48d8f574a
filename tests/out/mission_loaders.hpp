// What the loaders of ground stations ask of a mission file, so that a test can apply it without them.
// Each returns an empty string if the file would be taken, else the reason why not.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace alate::test {

/// QGroundControl: PlanMasterController, JsonHelper, MissionController (version 2), SimpleMissionItem, MissionItem;
/// and the mission version that MAVSDK asks for. Complex items are passed over.
std::string qgroundcontrol_refuses_plan(const std::string& text);

/// QGroundControl's reader of WPL text: exactly twelve cells between tabs in every line, no comments.
std::string qgroundcontrol_refuses_waypoints(const std::string& text);

/// MAVProxy (pymavlink's MAVWPLoader): twelve words in every line, whole numbers where it reads them.
std::string mavproxy_refuses_waypoints(const std::string& text);

}  // namespace alate::test
