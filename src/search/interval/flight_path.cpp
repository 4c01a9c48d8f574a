#include "search/interval/flight_path.hpp"

#include <algorithm>
#include <cmath>

#include "space/dubins/dubins_point.hpp"

namespace alate {

namespace {

constexpr double kGain = 1e-4;      ///< Metres; less is not worth a change.
constexpr double kRounding = 1e-6;  ///< Metres, of a way that is cut otherwise but stays the same.

bool same(const AltitudeLabel& a, const AltitudeLabel& b) {
  return a.low == b.low && a.high == b.high && a.ascent == b.ascent && a.free == b.free;
}
bool same(const BackwardLabel& a, const BackwardLabel& b) {
  return a.low == b.low && a.high == b.high && a.ascent == b.ascent && a.free == b.free;
}

}  // namespace

FlightPath::FlightPath(const FlightCost& cost, FlightEnd end, const Track& track, double z)
    : cost_(&cost), end_(std::move(end)) {
  for (const PlanarPiece& piece : track) {
    poses_.push_back(piece.start);
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
  note_end();
}

/// The end is another one.
void FlightPath::note_end() {
  least_climb_ = cost_->climb_weight() * std::max(0.0, end_.low() - forward_[0].low);
  backward_.back() = {.low = end_.low(), .high = end_.high(), .ascent = 0, .free = end_.low()};
  legs_.back().is_forward_old = legs_.back().is_backward_old = true;
  note_all();
}

/// Spends more or less of the goal's ball on altitude.
bool FlightPath::retilt(Stream& random) {
  if (end_.tolerance_m <= 0) return false;
  note_all();
  FlightPath before(*this);
  end_.tilt_rad = kPi / 2 * random.uniform();
  Leg last;
  if (make_leg(poses_.back(), nullptr, last)) {
    legs_.back() = std::move(last);
    note_end();
    if (total_ < before.total_ - kGain) return true;
  }
  *this = std::move(before);
  return false;
}

Track FlightPath::track() const {
  Track all;
  for (const Leg& leg : legs_) all.insert(all.end(), leg.track.begin(), leg.track.end());
  return all;
}

/// The altitudes that the start allows, up to pose `to`.
void FlightPath::note_forward(std::size_t to) {
  for (std::size_t i = 0; i < to; ++i) {
    Leg& leg = legs_[i];
    if (!leg.is_forward_old) continue;
    AltitudeLabel label = forward_[i];
    leg.cost = cost_->advance(leg.track, label);
    leg.is_forward_old = false;
    set_forward(i + 1, label);
  }
}

/// Those that the goal asks for, back to pose `from`.
void FlightPath::note_backward(std::size_t from) {
  for (std::size_t i = legs_.size(); i-- > from;) {
    Leg& leg = legs_[i];
    if (!leg.is_backward_old) continue;
    BackwardLabel label = backward_[i + 1];
    for (std::size_t k = leg.track.size(); k-- > 0 && label.alive();) cost_->band().advance(leg.track[k], label);
    leg.is_backward_old = false;
    if (same(label, backward_[i])) continue;
    backward_[i] = label;
    if (i > 0) legs_[i - 1].is_backward_old = true;
  }
}

void FlightPath::set_forward(std::size_t at, const AltitudeLabel& label) {
  if (same(label, forward_[at])) return;
  forward_[at] = label;
  if (at < legs_.size()) legs_[at].is_forward_old = true;
}

void FlightPath::note_all() {
  note_forward(legs_.size());
  note_backward(0);
  const auto meeting = meet(forward_.back(), backward_.back());
  total_ = meeting ? cost_->climb_weight() * meeting->ascent : kInfinity;
  for (const Leg& leg : legs_) total_ += leg.cost;
  total_ += over_range_with({}, {});
}

bool FlightPath::make_leg(const PlanarPose& from, const PlanarPose* to, Leg& leg) const {
  const double radius = cost_->band().radius_m();
  leg = {};
  if (to == nullptr) {
    append(leg.track, shortest_dubins_to_point(from, end_.place(), radius));
    cut_at_end(leg.track, end_);
  } else {
    append(leg.track, shortest_dubins(from, *to, radius));
  }
  return !leg.track.empty() &&
         std::ranges::all_of(leg.track, [](const PlanarPiece& piece) { return piece.length_m >= kLeastPiece_m; });
}

bool FlightPath::try_change(const Change& change) {
  // With fewer poses the same cost is better: there is room again for new ones where they help.
  const double most = change.between.empty() ? total_ + kRounding : total_ - kGain;
  double rest = least_climb_;
  for (std::size_t i = 0; i < legs_.size(); ++i)
    if (i < change.from || i >= change.to) rest += legs_[i].cost;
  const bool at_end = change.to == legs_.size();
  std::vector<Leg> legs(change.between.size() + 1);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const PlanarPose& from = k == 0 ? poses_[change.from] : change.between[k - 1];
    const bool last = k + 1 == legs.size();
    const PlanarPose* to = !last ? &change.between[k] : at_end ? nullptr : &poses_[change.to];
    if (!make_leg(from, to, legs[k])) return false;
    rest += cost_->length_weight() * length_of(legs[k].track);
    if (rest >= most) return false;
  }
  return take_if(change, std::move(legs), most);
}

/// Takes new legs if the whole way then costs less than `most`. The cost of legs behind them stays as it was until
/// labels are carried there.
bool FlightPath::take_if(const Change& change, std::vector<Leg> legs, double most) {
  note_forward(change.from);
  note_backward(change.to);
  AltitudeLabel label = forward_[change.from];
  std::vector<AltitudeLabel> labels;
  double sum = 0;
  for (std::size_t i = 0; i < legs_.size(); ++i)
    if (i < change.from || i >= change.to) sum += legs_[i].cost;
  for (Leg& leg : legs) {
    leg.cost = cost_->advance(leg.track, label);
    leg.is_forward_old = false;
    labels.push_back(label);
    sum += leg.cost;
    if (sum + least_climb_ >= most) return false;
  }
  const auto meeting = meet(label, backward_[change.to]);
  if (!meeting) return false;
  sum += cost_->climb_weight() * meeting->ascent + over_range_with(change, legs);
  if (sum >= most) return false;

  const auto replace = [&](auto& list, std::size_t from, std::size_t to, const auto& by) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(from), list.begin() + static_cast<std::ptrdiff_t>(to));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(from), by.begin(), by.end());
  };
  labels.pop_back();
  replace(poses_, change.from + 1, std::min(change.to, poses_.size()), change.between);
  replace(legs_, change.from, change.to, legs);
  replace(forward_, change.from + 1, change.to, labels);
  replace(backward_, change.from + 1, change.to, std::vector<BackwardLabel>(labels.size()));
  set_forward(change.from + legs.size(), label);
  total_ = sum;
  return true;
}

/// Of the whole way after a change.
double FlightPath::over_range_with(const Change& change, const std::vector<Leg>& legs) const {
  if (!cost_->has_range()) return 0;
  double length = 0;
  for (std::size_t i = 0; i < legs_.size(); ++i)
    if (i < change.from || i >= change.to) length += length_of(legs_[i].track);
  for (const Leg& leg : legs) length += length_of(leg.track);
  return cost_->over_range(length);
}

void FlightPath::shorten(RunContext& run) {
  for (std::size_t i = 0; i + 1 < legs_.size(); ++i)
    for (std::size_t span = legs_.size() - i; span > 1 && run.keep_going(); span = span * 2 / 3)
      if (try_change({.from = i, .to = i + span, .between = {}})) break;
  note_all();
}

/// A pose where two pieces of a leg meet, or within a straight one: it changes nothing, but gives the next changes a
/// place to bend.
void FlightPath::split(Stream& random) {
  const std::size_t i = random.below(legs_.size());
  const Track& track = legs_[i].track;
  const std::size_t k = random.below(track.size());
  std::vector<Track> halves(2);
  halves[0].assign(track.begin(), track.begin() + static_cast<std::ptrdiff_t>(k));
  halves[1].assign(track.begin() + static_cast<std::ptrdiff_t>(k), track.end());
  if (track[k].steering == Steering::straight && track[k].length_m > 2 * kLeastPiece_m) {
    const double at = kLeastPiece_m + random.uniform() * (track[k].length_m - 2 * kLeastPiece_m);
    halves[0].push_back(track[k]);
    halves[0].back().length_m = at;
    halves[1].front().start = track[k].at(at);
    halves[1].front().length_m -= at;
  }
  if (halves[0].empty()) return;
  std::vector<Leg> legs(2);
  for (std::size_t half = 0; half < 2; ++half) legs[half].track = std::move(halves[half]);
  const Change change{.from = i, .to = i + 1, .between = {legs[1].track.front().start}};
  take_if(change, std::move(legs), total_ + kRounding);
}

/// Poses k to k + count - 1, moved by one offset of about `size`.
std::vector<PlanarPose> FlightPath::moved_poses(std::size_t k, std::size_t count, double size, Stream& random) const {
  const double direction = 2 * kPi * random.uniform();
  const Vec2 offset = size * (0.5 + random.uniform()) * Vec2(std::cos(direction), std::sin(direction));
  const bool along_chord = random.uniform() < 0.5;
  std::vector<PlanarPose> moved;
  for (std::size_t i = k; i < k + count; ++i) {
    const Vec2 place = poses_[i].position() + offset;
    double heading = poses_[i].heading;
    if (along_chord) {
      const Vec2 before = poses_[i - 1].position();
      const Vec2 after = i + 1 < poses_.size() ? poses_[i + 1].position() : end_.place();
      heading = std::atan2(after.y() - before.y(), after.x() - before.x());
    }
    heading += (random.uniform() - 0.5) * std::min(1.0, size / cost_->band().radius_m());
    moved.push_back(planar_pose(place.x(), place.y(), heading));
  }
  return moved;
}

bool FlightPath::move_some(Stream& random) {
  constexpr double kSmallest = 1.0 / 16;  // of the radius; each further size is twice that
  double all = 0;
  for (const double chance : size_chances_) all += chance;
  double point = random.uniform() * all;
  std::size_t size = 0;
  while (size + 1 < size_chances_.size() && point >= size_chances_[size]) point -= size_chances_[size++];
  const double size_m = cost_->band().radius_m() * kSmallest * std::exp2(static_cast<double>(size));
  const std::size_t k = 1 + random.below(legs_.size() - 1);
  const std::size_t most = std::min<std::size_t>(legs_.size() - k, 4);
  const std::size_t count = random.uniform() < 0.6 ? 1 : 1 + random.below(most);
  const bool kept = try_change({.from = k - 1, .to = k + count, .between = moved_poses(k, count, size_m, random)});
  constexpr double kMemory = 0.98;
  size_chances_[size] = kMemory * size_chances_[size] + (1 - kMemory) * (kept ? 1 : kLeastChance);
  return kept;
}

int FlightPath::better(Stream& random, int trials, RunContext& run) {
  constexpr std::size_t kMostLegs = 80;
  constexpr int kPollEvery = 16;
  int kept = 0;
  for (int trial = 0; trial < trials; ++trial) {
    if (trial % kPollEvery == 0 && !run.keep_going()) break;
    const double kind = random.uniform();
    const std::size_t legs = legs_.size();
    if (kind < 0.02) {
      kept += retilt(random) ? 1 : 0;
    } else if (kind < 0.1 && legs < kMostLegs) {
      split(random);
    } else if (kind < 0.3 && legs > 1) {
      const std::size_t i = random.below(legs - 1);
      const std::size_t j = i + 2 + random.below(std::min<std::size_t>(legs - i - 1, 6));
      kept += try_change({.from = i, .to = j, .between = {}}) ? 1 : 0;
    } else if (legs > 1) {
      kept += move_some(random) ? 1 : 0;
    }
  }
  note_all();
  return kept;
}

}  // namespace alate
