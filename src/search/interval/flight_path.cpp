#include "search/interval/flight_path.hpp"

#include <cmath>

namespace alate {

namespace {

constexpr double kGain = 1e-6;  ///< Metres; less is rounding.

bool same(const AltitudeLabel& a, const AltitudeLabel& b) {
  return a.low == b.low && a.high == b.high && a.ascent == b.ascent && a.free == b.free;
}
bool same(const BackwardLabel& a, const BackwardLabel& b) {
  return a.low == b.low && a.high == b.high && a.ascent == b.ascent && a.free == b.free;
}

}  // namespace

FlightPath::FlightPath(const FlightCost& cost, const FlightEnd& end, const Track& track, double z)
    : cost_(&cost), end_(end) {
  for (const TrackPiece& piece : track) {
    poses_.push_back(piece.from);
    legs_.push_back({.track = {piece}, .cost = 0});
  }
  // The last arc and straight piece are one leg, to be led to the end as a whole.
  if (legs_.size() > 1 && legs_.back().track.front().steering == Steering::straight) {
    legs_[legs_.size() - 2].track.push_back(track.back());
    legs_.pop_back();
    poses_.pop_back();
  }
  forward_.resize(legs_.size() + 1);
  backward_.resize(legs_.size() + 1);
  forward_[0] = AltitudeLabel::at(z);
  backward_.back() = {.low = end.low, .high = end.high, .ascent = 0, .free = end.low};
  note_forward(0);
  note_backward(legs_.size());
  const auto meeting = meet(forward_.back(), backward_.back());
  total_ = meeting ? cost_->climb_weight() * meeting->ascent : kInfinity;
  for (const Leg& leg : legs_) total_ += leg.cost;
}

Track FlightPath::track() const {
  Track all;
  for (const Leg& leg : legs_) all.insert(all.end(), leg.track.begin(), leg.track.end());
  return all;
}

/// Anew from pose `from` on, until nothing changes.
void FlightPath::note_forward(std::size_t from) {
  for (std::size_t i = from; i < legs_.size(); ++i) {
    AltitudeLabel label = forward_[i];
    const double cost = cost_->advance(legs_[i].track, label);
    const bool unchanged = same(label, forward_[i + 1]) && cost == legs_[i].cost;
    forward_[i + 1] = label;
    legs_[i].cost = cost;
    if (unchanged) return;
  }
}

void FlightPath::note_backward(std::size_t from) {
  for (std::size_t i = from; i-- > 0;) {
    BackwardLabel label = backward_[i + 1];
    for (std::size_t k = legs_[i].track.size(); k-- > 0 && label.alive();)
      cost_->band().advance(legs_[i].track[k], label);
    if (same(label, backward_[i])) return;
    backward_[i] = label;
  }
}

bool FlightPath::make_leg(const PlanarPose& from, const PlanarPose* to, Leg& leg) const {
  const double radius = cost_->band().radius_m();
  leg = {};
  if (to == nullptr) {
    if (!append_way_to(leg.track, from, end_.place, radius)) return false;
    cut_at_end(leg.track, end_);
  } else {
    append(leg.track, shortest_dubins(from, *to, radius));
  }
  constexpr double kLeastStraight_m = 0.1;  // shorter ones have no direction to the rounding of places
  for (const TrackPiece& piece : leg.track)
    if (piece.steering == Steering::straight && piece.length_m < kLeastStraight_m) return false;
  return !leg.track.empty();
}

bool FlightPath::try_change(const Change& change) {
  double old_cost = 0;
  for (std::size_t i = change.from; i < change.to; ++i) old_cost += legs_[i].cost;
  const bool at_end = change.to == legs_.size();
  std::vector<Leg> legs(change.between.size() + 1);
  AltitudeLabel label = forward_[change.from];
  double new_cost = 0;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const PlanarPose& from = k == 0 ? poses_[change.from] : change.between[k - 1];
    const bool last = k + 1 == legs.size();
    const PlanarPose* to = !last ? &change.between[k] : at_end ? nullptr : &poses_[change.to];
    if (!make_leg(from, to, legs[k])) return false;
    if (length_of(legs[k].track) + new_cost > old_cost + 1e4) return false;
    legs[k].cost = cost_->advance(legs[k].track, label);
    if (!label.alive()) return false;
    new_cost += legs[k].cost;
  }
  const auto meeting = meet(label, backward_[change.to]);
  if (!meeting) return false;
  double rest = 0;
  for (std::size_t i = 0; i < change.from; ++i) rest += legs_[i].cost;
  for (std::size_t i = change.to; i < legs_.size(); ++i) rest += legs_[i].cost;
  const double total = rest + new_cost + cost_->climb_weight() * meeting->ascent;
  if (total >= total_ - kGain) return false;

  const auto at = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t end_pose = at_end ? poses_.size() : change.to;
  poses_.erase(at(poses_, change.from + 1), at(poses_, end_pose));
  poses_.insert(at(poses_, change.from + 1), change.between.begin(), change.between.end());
  legs_.erase(at(legs_, change.from), at(legs_, change.to));
  legs_.insert(at(legs_, change.from), legs.begin(), legs.end());
  forward_.erase(at(forward_, change.from + 1), at(forward_, change.to));
  forward_.insert(at(forward_, change.from + 1), change.between.size(), AltitudeLabel{});
  backward_.erase(at(backward_, change.from + 1), at(backward_, change.to));
  backward_.insert(at(backward_, change.from + 1), change.between.size(), BackwardLabel{});
  note_forward(change.from);
  note_backward(change.from + legs.size());
  total_ = cost_->climb_weight() * meet(forward_.back(), backward_.back())->ascent;
  for (const Leg& leg : legs_) total_ += leg.cost;
  return true;
}

void FlightPath::shorten(RunContext& run) {
  for (std::size_t i = 0; i + 1 < legs_.size(); ++i)
    for (std::size_t j = legs_.size(); j > i + 1 && run.keep_going(); --j)
      if (try_change({.from = i, .to = j, .between = {}})) break;
}

/// A pose in the middle of a leg; changes nothing but gives the next changes a place to bend.
void FlightPath::split(Stream& random) {
  const std::size_t i = random.below(legs_.size());
  Leg& leg = legs_[i];
  double at = random.uniform() * length_of(leg.track);
  std::size_t k = 0;
  while (k + 1 < leg.track.size() && at > leg.track[k].length_m) at -= leg.track[k++].length_m;
  constexpr double kLeast_m = 1;
  TrackPiece& piece = leg.track[k];
  if (at < kLeast_m || at > piece.length_m - kLeast_m) return;
  const PlanarPose pose = pose_on(piece, at, cost_->band().radius_m());
  Leg second;
  second.track.push_back({pose, piece.steering, piece.length_m - at});
  second.track.insert(second.track.end(), leg.track.begin() + static_cast<std::ptrdiff_t>(k) + 1, leg.track.end());
  piece.length_m = at;
  leg.track.resize(k + 1);
  const auto after = static_cast<std::ptrdiff_t>(i) + 1;
  poses_.insert(poses_.begin() + after, pose);
  legs_.insert(legs_.begin() + after, second);
  forward_.insert(forward_.begin() + after, AltitudeLabel{});
  backward_.insert(backward_.begin() + after, BackwardLabel{});
  note_forward(i);
  note_backward(i + 2);
  const auto meeting = meet(forward_.back(), backward_.back());
  total_ = meeting ? cost_->climb_weight() * meeting->ascent : kInfinity;
  for (const Leg& each : legs_) total_ += each.cost;
}

PlanarPose FlightPath::moved_pose(std::size_t k, Stream& random) const {
  const double radius = cost_->band().radius_m();
  const PlanarPose& at = poses_[k];
  const double size = radius * std::exp2(random.uniform() * 7 - 4);
  const double direction = 2 * kPi * random.uniform();
  const Vec2 place = at.position() + size * Vec2(std::cos(direction), std::sin(direction));
  double heading = at.heading;
  if (random.uniform() < 0.5) {
    const Vec2 before = poses_[k - 1].position();
    const Vec2 after = k + 1 < poses_.size() ? poses_[k + 1].position() : end_.place;
    heading = std::atan2(after.y() - before.y(), after.x() - before.x());
  }
  heading += (random.uniform() - 0.5) * std::min(1.0, size / radius);
  return planar_pose(place.x(), place.y(), heading);
}

int FlightPath::better(Stream& random, int trials, RunContext& run) {
  constexpr std::size_t kMostLegs = 80;
  int kept = 0;
  for (int trial = 0; trial < trials; ++trial) {
    if (trial % 16 == 0 && !run.keep_going()) break;
    const double kind = random.uniform();
    const std::size_t legs = legs_.size();
    if (kind < 0.15 && legs < kMostLegs) {
      split(random);
    } else if (kind < 0.4 && legs > 1) {
      const std::size_t i = random.below(legs - 1);
      const std::size_t j = i + 2 + random.below(std::min<std::size_t>(legs - i - 1, 6));
      kept += try_change({.from = i, .to = j, .between = {}}) ? 1 : 0;
    } else if (legs > 1) {
      const std::size_t k = 1 + random.below(legs - 1);
      kept += try_change({.from = k - 1, .to = k + 1, .between = {moved_pose(k, random)}}) ? 1 : 0;
    }
  }
  return kept;
}

}  // namespace alate
