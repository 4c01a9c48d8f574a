#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "check/rules.hpp"

namespace alate {

namespace {

constexpr double kSameAngle = 1e-9;

Mat3 start_attitude(double heading_rad) {
  const Vec3 forward = direction_of(heading_rad);
  const Vec3 up = Vec3::UnitZ();
  Mat3 attitude;
  attitude << forward, up.cross(forward), up;
  return attitude;
}

Mat3 rotated(const Mat3& attitude, const AttitudeAction& action) {
  using Turn = Eigen::AngleAxisd;
  return attitude * Turn(action.roll_rad, Vec3::UnitX()).toRotationMatrix() *
         Turn(-action.pitch_rad, Vec3::UnitY()).toRotationMatrix() *
         Turn(-action.yaw_rad, Vec3::UnitZ()).toRotationMatrix();
}

/// The allowed angle nearest to `angle`.
double nearest(const std::vector<double>& allowed, double angle) {
  return *std::ranges::min_element(allowed, {}, [&](double a) { return std::abs(a - angle); });
}

/// Reports the first angle of the action that the scenario does not have.
bool judge_action(const Vehicle& vehicle, const AttitudeAction& action, Finding at, RuleReport& report) {
  const std::vector<std::pair<double, double>> angles{{action.roll_rad, nearest(vehicle.roll_rad, action.roll_rad)},
                                                      {action.pitch_rad, nearest(vehicle.pitch_rad, action.pitch_rad)},
                                                      {action.yaw_rad, nearest(vehicle.yaw_rad, action.yaw_rad)}};
  for (const auto& [given, allowed] : angles) {
    if (std::abs(given - allowed) <= kSameAngle) continue;
    at.value = degrees(std::abs(given - allowed));
    at.unit = "deg";
    report.at_most(at);
    return false;
  }
  return true;
}

}  // namespace

RuleReport judge_step(const Flight& flight) {
  RuleReport report("step");
  const Vehicle& vehicle = flight.site.vehicle;
  const auto& states = flight.route.states;
  if (!vehicle.has_attitude_steps()) {
    report.not_checked("the scenario gives no step_m with roll_deg, pitch_deg and yaw_deg");
    return report;
  }
  if (std::ranges::none_of(states, [](const RouteState& s) { return s.action.has_value(); })) {
    report.not_checked("the file carries no actions");
    return report;
  }
  Mat3 attitude = start_attitude(flight.site.mission.heading_rad);
  for (std::size_t i = 1; i < states.size(); ++i) {
    const AttitudeAction action = states[i].action.value_or(AttitudeAction{});
    Finding at{.leg = i, .where = states[i].position};
    judge_action(vehicle, action, at, report);
    attitude = rotated(attitude, action);
    const Vec3 expected = states[i - 1].position + *vehicle.step_m * attitude.col(0);
    at.value = (states[i].position - expected).norm();
    report.at_most(at);
  }
  return report;
}

}  // namespace alate
