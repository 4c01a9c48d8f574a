#include "search/interval/interval_astar.hpp"

#include <algorithm>
#include <cmath>

#include "space/dubins/dubins_point.hpp"

namespace alate {

namespace {

constexpr int kHeadings = BinPages::kHeadings;
constexpr std::uint64_t kPollEvery = 64;

Box2 area_of(const World& world) {
  const Site& site = world.site();
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return raster->area;
  if (const auto* peaks = std::get_if<PeakGround>(&site.ground)) return peaks->area;
  const Vec2 a = site.mission.start.head<2>();
  const Vec2 b = site.mission.goal.head<2>();
  const double around = 0.5 * (a - b).norm() + 20 * *site.vehicle.turn_radius_m;
  return {a.cwiseMin(b).array() - around, a.cwiseMax(b).array() + around};
}

}  // namespace

void cut_at_end(Track& track, const FlightEnd& end) {
  if (track.empty() || end.radius_m() <= 0) return;
  PlanarPiece& last = track.back();
  if (last.steering != Steering::straight) return;
  const double to_end = (end.place() - last.start.position()).norm();
  const double cut = std::min(last.length_m, end.radius_m() - std::max(0.0, to_end - last.length_m));
  const double left = last.length_m - cut;
  if (left <= 0 && track.size() > 1)
    track.pop_back();
  else
    last.length_m = std::max(left, std::min(last.length_m, kLeastPiece_m));
}

IntervalAStar::IntervalAStar(const FlightCost& cost, const ClimbField& to_go)
    : cost_(&cost), to_go_(&to_go), area_(area_of(cost.band().world())) {}

void IntervalAStar::turn_to(const FlightCost& cost, const ClimbField& to_go) {
  cost_ = &cost;
  to_go_ = &to_go;
  area_ = area_of(cost.band().world());
}

double IntervalAStar::rest(const Node& node) const {
  const auto at = [&](double z) {
    const double to_go = (*to_go_)({node.pose.x, node.pose.y, z});
    return to_go + cost_->climb_weight() * node.label.ascent_to(z);
  };
  return std::min({at(node.label.free), at(node.label.high), at(node.label.low)});
}

std::uint32_t& IntervalAStar::bin_of(const PlanarPose& pose) {
  const auto column = std::clamp(static_cast<int>((pose.x - area_.min.x()) / options_.bin_m), 0, columns_ - 1);
  const auto row = std::clamp(static_cast<int>((pose.y - area_.min.y()) / options_.bin_m), 0, rows_ - 1);
  const int heading = static_cast<int>(std::lround(pose.heading / (2 * kPi) * kHeadings)) & (kHeadings - 1);
  return bins_.at(column, row, heading);
}

bool IntervalAStar::is_dominated(std::uint32_t& bin, const Node& node) const {
  const double weight = cost_->climb_weight();
  int count = 0;
  for (std::uint32_t i = bin; i != kNone; i = nodes_[i].next_in_bin, ++count) {
    const Node& other = nodes_[i];
    const bool cheaper = other.cost + weight * other.label.ascent_to(std::max(other.label.low, node.label.free)) <=
                         node.cost + weight * node.label.ascent;
    constexpr double kAlike_m = 1.5;
    const bool wider = other.label.low <= node.label.low + kAlike_m && other.label.high >= node.label.high - kAlike_m;
    if (cheaper && wider) return true;
  }
  constexpr int kMostLabels = 12;
  return count >= kMostLabels;
}

void IntervalAStar::add(Node node) {
  const double rest_cost = rest(node);
  if (!std::isfinite(rest_cost)) return;
  std::uint32_t& bin = bin_of(node.pose);
  if (is_dominated(bin, node)) return;
  node.next_in_bin = bin;
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  open_.push_back({node.cost + options_.epsilon * rest_cost, index});
  std::ranges::push_heap(open_, std::greater{});
  nodes_.push_back(node);
  bin = index;
}

void IntervalAStar::expand(std::uint32_t from) {
  for (const auto& [steering, length_m] : primitives_) {
    Node next{.piece = {steering, nodes_[from].pose, length_m, cost_->band().radius_m()},
              .label = nodes_[from].label,
              .parent = from};
    const double step = cost_->advance(next.piece, next.label);
    if (!next.label.alive()) continue;
    next.pose = next.piece.end();
    next.cost = nodes_[from].cost + step;
    add(next);
  }
}

std::optional<Track> IntervalAStar::shot(std::uint32_t from) const {
  Track track;
  append(track, shortest_dubins_to_point(nodes_[from].pose, end_.place(), cost_->band().radius_m()));
  cut_at_end(track, end_);
  AltitudeLabel label = nodes_[from].label;
  for (const PlanarPiece& piece : track)
    if (!cost_->band().advance(piece, label)) return std::nullopt;
  if (label.low > end_.high() || label.high < end_.low()) return std::nullopt;
  return track;
}

IntervalAStar::Open IntervalAStar::pop_open() {
  std::ranges::pop_heap(open_, std::greater{});
  const Open top = open_.back();
  open_.pop_back();
  return top;
}

void IntervalAStar::begin(const FlightStart& start, const FlightEnd& end, const IntervalSearchOptions& options) {
  end_ = end;
  options_ = options;
  // A tiny turn radius or a vast ground would ask for more bins than memory holds.
  constexpr double kMostAcross = 2048;
  options_.bin_m = std::max(options.bin_m, (area_.max - area_.min).maxCoeff() / kMostAcross);
  columns_ = static_cast<int>((area_.max.x() - area_.min.x()) / options_.bin_m) + 1;
  rows_ = static_cast<int>((area_.max.y() - area_.min.y()) / options_.bin_m) + 1;
  bins_.clear(columns_, rows_);
  nodes_.clear();
  open_.clear();
  expansions_ = 0;
  until_shot_ = 0;
  using enum Steering;
  const double arc = cost_->band().radius_m() * kPi / 8;
  primitives_ = {{left, arc},
                 {right, arc},
                 {left, 2 * arc},
                 {right, 2 * arc},
                 {straight, options_.bin_m},
                 {straight, 3 * options_.bin_m}};
  for (const PlanarPose& pose : start.poses) add({.pose = pose, .label = AltitudeLabel::at(start.z)});
}

Track IntervalAStar::track_to(std::uint32_t node) const {
  Track track;
  for (; nodes_[node].parent != kNone; node = nodes_[node].parent) track.push_back(nodes_[node].piece);
  std::ranges::reverse(track);
  return track;
}

std::optional<Track> IntervalAStar::find(const FlightStart& start, const FlightEnd& end,
                                         const IntervalSearchOptions& options, RunContext& run) {
  begin(start, end, options);
  return go_on(std::numeric_limits<std::uint64_t>::max(), run);
}

std::optional<Track> IntervalAStar::go_on(std::uint64_t most_expansions, RunContext& run) {
  for (std::uint64_t count = 0; !exhausted() && count < most_expansions; ++count) {
    const std::uint32_t at = pop_open().node;
    if (++expansions_ % kPollEvery == 0 && !run.keep_going()) break;
    if (until_shot_-- == 0) {
      if (const auto last = shot(at)) {
        Track whole = track_to(at);
        whole.insert(whole.end(), last->begin(), last->end());
        return whole;
      }
      // The farther the goal, the rarer.
      const double distance = (end_.place() - nodes_[at].pose.position()).norm();
      until_shot_ = static_cast<std::uint64_t>(std::clamp(distance / (20 * cost_->band().radius_m()), 0.0, 31.0));
    }
    expand(at);
  }
  return std::nullopt;
}

}  // namespace alate
