#include "shortcuts.hpp"

#include <algorithm>
#include <cmath>

namespace alate::peers {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kGain = 1e-4;       ///< Metres; less is not worth a change.
constexpr double kAtWaypoint = 0.3;  ///< Share of places that are waypoints.

}  // namespace

ShorterWay::ShorterWay(const FlightLegs& legs, Way way)
    : legs_(&legs),
      way_(std::move(way)),
      passages_{{.label = AltitudeLabel::at(way_.front().z)}},
      total_(fly(0, kInfinity)) {}

/// What the way costs, known anew from waypoint `first` on; infinite, as soon as that is clear, if `most` or more.
double ShorterWay::fly(std::size_t first, double most) {
  passages_.resize(first + 1);
  for (std::size_t i = first; i + 1 < way_.size(); ++i) {
    Passage next = passages_.back();
    next.cost += legs_->advance(way_[i].pose, way_[i + 1].pose, next.label);
    if (!(next.cost < most)) return kInfinity;
    passages_.push_back(next);
  }
  const double total = passages_.back().cost + legs_->arrive(passages_.back().label);
  return total < most ? total : kInfinity;
}

/// Puts `by` in place of the waypoints between `first` and `last`; if `last` is beyond the way, of all behind `first`.
bool ShorterWay::replace(std::size_t first, std::size_t last, const std::vector<PlanarPose>& by) {
  Way way(way_.begin(), way_.begin() + static_cast<std::ptrdiff_t>(first) + 1);
  for (const PlanarPose& pose : by) way.push_back({.pose = pose, .z = way_.front().z});
  if (last < way_.size()) way.insert(way.end(), way_.begin() + static_cast<std::ptrdiff_t>(last), way_.end());
  std::swap(way, way_);
  std::vector<Passage> passages = passages_;
  const double total = fly(first, total_ - kGain);
  if (total < total_) {
    total_ = total;
    return true;
  }
  way_ = std::move(way);
  passages_ = std::move(passages);
  return false;
}

/// Where the way has cost so much, or the waypoint before.
ShorterWay::Place ShorterWay::place_at(double cost, ompl::RNG& random) const {
  std::size_t leg = 0;
  while (leg + 2 < way_.size() && passages_[leg + 1].cost <= cost) ++leg;
  const double length = passages_[leg + 1].cost - passages_[leg].cost;
  if (random.uniform01() < kAtWaypoint || length <= 0) return {.leg = leg};
  return {.leg = leg, .part = std::clamp((cost - passages_[leg].cost) / length, 0.0, 1.0)};
}

PlanarPose ShorterWay::pose_at(const Place& place) const {
  if (place.part == 0) return way_[place.leg].pose;
  return legs_->pose_on(way_[place.leg].pose, way_[place.leg + 1].pose, place.part);
}

bool ShorterWay::shortcut(ompl::RNG& random) {
  constexpr double kToGoal = 0.15;
  const double whole = passages_.back().cost;
  const double from_cost = random.uniform01() * whole;
  const Place from = place_at(from_cost, random);
  std::vector<PlanarPose> by;
  if (from.part > 0) by.push_back(pose_at(from));
  if (random.uniform01() < kToGoal) {
    const auto shot = legs_->shot_to_goal(pose_at(from));
    if (!shot) return false;
    by.push_back(*shot);
    return replace(from.leg, way_.size(), by);
  }
  // Near or far: corners of all sizes.
  const double reach = std::exp(random.uniformReal(std::log(legs_->radius_m()), std::log(whole)));
  const Place to = place_at(std::min(whole, from_cost + reach), random);
  if (to.leg <= from.leg) return false;
  if (to.part > 0) by.push_back(pose_at(to));
  const std::size_t last = to.part > 0 ? to.leg + 1 : to.leg;
  if (last == from.leg + 1 && by.empty()) return false;
  return replace(from.leg, last, by);
}

/// Aside by an eighth to eight radii, headed as before or along the chord between its neighbours.
PlanarPose ShorterWay::moved(const PlanarPose& from, std::size_t before, std::size_t after, ompl::RNG& random) const {
  const double size_m = legs_->radius_m() * std::exp2(random.uniformReal(-3, 3));
  const Vec2 place =
      from.position() + Vec2(random.gaussian(0, size_m), random.gaussian(0, size_m)) / std::numbers::sqrt2;
  double heading = from.heading;
  if (random.uniformBool()) {
    const Vec2 chord = way_[after].pose.position() - way_[before].pose.position();
    heading = std::atan2(chord.y(), chord.x());
  }
  heading += random.gaussian(0, std::min(0.5, size_m / legs_->radius_m() / 4));
  return planar_pose(place.x(), place.y(), heading);
}

bool ShorterWay::perturb(ompl::RNG& random) {
  const Place place = place_at(random.uniform01() * passages_.back().cost, random);
  // Between waypoints a new one is put in beside the leg.
  if (place.part > 0)
    return replace(place.leg, place.leg + 1, {moved(pose_at(place), place.leg, place.leg + 1, random)});
  const std::size_t k = place.leg;
  if (k == 0) return false;
  const PlanarPose there = moved(way_[k].pose, k - 1, k + 1, random);
  if (k + 2 < way_.size()) return replace(k - 1, k + 1, {there});
  const auto shot = legs_->shot_to_goal(there);
  return shot && replace(k - 1, way_.size(), {there, *shot});
}

}  // namespace alate::peers
