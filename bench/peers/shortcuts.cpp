#include "shortcuts.hpp"

#include <algorithm>
#include <cmath>

namespace alate::peers {

namespace {

constexpr double kGain = 1e-4;       ///< Metres; less is not worth a change.
constexpr double kAtWaypoint = 0.3;  ///< Share of places that are waypoints.

}  // namespace

ShorterWay::ShorterWay(const FlightLegs& legs, Way way) : legs_(&legs), way_(std::move(way)) { note_costs(); }

void ShorterWay::note_costs() {
  costs_.clear();
  total_ = 0;
  for (std::size_t i = 1; i < way_.size(); ++i) {
    costs_.push_back(legs_->cost(way_[i - 1], way_[i]));
    total_ += costs_.back();
  }
}

void ShorterWay::settle() {
  legs_->settle_altitudes(way_);
  note_costs();
}

/// By cost along the way, at a waypoint or between two.
ShorterWay::Place ShorterWay::draw_place(ompl::RNG& random) const {
  double rest = random.uniform01() * total_;
  std::size_t leg = 0;
  while (leg + 1 < costs_.size() && rest >= costs_[leg]) rest -= costs_[leg++];
  if (random.uniform01() < kAtWaypoint || costs_[leg] <= 0) return {.leg = leg};
  return {.leg = leg, .part = std::min(rest / costs_[leg], 1.0)};
}

/// Puts `by` in place of the waypoints between `first` and `last`; if `last` is beyond the way, of all behind `first`.
bool ShorterWay::replace(std::size_t first, std::size_t last, const Way& by) {
  const bool to_end = last >= way_.size();
  Way piece{way_[first]};
  piece.insert(piece.end(), by.begin(), by.end());
  if (!to_end) piece.push_back(way_[last]);
  double before = 0;
  for (std::size_t i = first; i < (to_end ? costs_.size() : last); ++i) before += costs_[i];
  std::vector<double> costs;
  double after = 0;
  for (std::size_t i = 1; i < piece.size(); ++i) {
    costs.push_back(legs_->cost(piece[i - 1], piece[i]));
    after += costs.back();
    if (after >= before - kGain) return false;
  }
  for (std::size_t i = 1; i < piece.size(); ++i)
    if (!legs_->can_fly(piece[i - 1], piece[i])) return false;
  const auto at = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
  way_.erase(at(way_, first + 1), to_end ? way_.end() : at(way_, last));
  way_.insert(at(way_, first + 1), by.begin(), by.end());
  costs_.erase(at(costs_, first), to_end ? costs_.end() : at(costs_, last));
  costs_.insert(at(costs_, first), costs.begin(), costs.end());
  total_ += after - before;
  return true;
}

bool ShorterWay::shortcut(ompl::RNG& random) {
  constexpr double kToGoal = 0.15;
  Place from = draw_place(random);
  Place to = draw_place(random);
  if (std::pair(to.leg, to.part) < std::pair(from.leg, from.part)) std::swap(from, to);
  Way by;
  if (from.part > 0) {
    const auto point = legs_->point_on(way_[from.leg], way_[from.leg + 1], from.part);
    if (!point) return false;
    by.push_back(*point);
  }
  if (random.uniform01() < kToGoal) {
    const auto shot = legs_->shot_to_goal(by.empty() ? way_[from.leg] : by.back());
    if (!shot) return false;
    by.push_back(*shot);
    return replace(from.leg, way_.size(), by);
  }
  if (from.leg == to.leg) return false;
  if (to.part > 0) {
    const auto point = legs_->point_on(way_[to.leg], way_[to.leg + 1], to.part);
    if (!point) return false;
    by.push_back(*point);
  }
  const std::size_t last = to.part > 0 ? to.leg + 1 : to.leg;
  if (last == from.leg + 1 && by.empty()) return false;
  return replace(from.leg, last, by);
}

/// Aside by an eighth to eight radii, headed as before or along the chord between its neighbours.
Waypoint ShorterWay::moved(const Waypoint& from, std::size_t before, std::size_t after, ompl::RNG& random) const {
  const double size_m = legs_->radius_m() * std::exp2(random.uniformReal(-3, 3));
  const Vec2 place =
      from.pose.position() + Vec2(random.gaussian(0, size_m), random.gaussian(0, size_m)) / std::numbers::sqrt2;
  double heading = from.pose.heading;
  if (random.uniformBool()) {
    const Vec2 chord = way_[after].pose.position() - way_[before].pose.position();
    heading = std::atan2(chord.y(), chord.x());
  }
  heading += random.gaussian(0, std::min(0.5, size_m / legs_->radius_m() / 4));
  Waypoint moved{.pose = planar_pose(place.x(), place.y(), heading), .z = from.z + random.gaussian(0, size_m / 10)};
  if (const auto altitudes = legs_->altitudes(moved.pose))
    moved.z = std::clamp(moved.z, altitudes->first, altitudes->second);
  return moved;
}

bool ShorterWay::perturb(ompl::RNG& random) {
  const Place place = draw_place(random);
  // A waypoint of the way is moved; elsewhere a new one is put in beside the leg.
  if (place.part == 0) {
    const std::size_t k = place.leg;
    if (k == 0) return false;
    const Waypoint there = moved(way_[k], k - 1, k + 1, random);
    if (k + 2 == way_.size() && random.uniformBool()) {
      const auto shot = legs_->shot_to_goal(there);
      return shot && replace(k - 1, way_.size(), {there, *shot});
    }
    return replace(k - 1, k + 1, {there});
  }
  const auto point = legs_->point_on(way_[place.leg], way_[place.leg + 1], place.part);
  return point && replace(place.leg, place.leg + 1, {moved(*point, place.leg, place.leg + 1, random)});
}

}  // namespace alate::peers
