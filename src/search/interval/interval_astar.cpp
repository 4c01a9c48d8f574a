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

std::vector<PlanarPose> any_heading(const Vec2& at, const Vec2& towards) {
  const Vec2 way = towards - at;
  std::vector<PlanarPose> poses;
  for (int k = 0; k < kHeadings; ++k)
    poses.push_back(planar_pose(at.x(), at.y(), std::atan2(way.y(), way.x()) + 2 * kPi * k / kHeadings));
  return poses;
}

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

IntervalAStar::Bin IntervalAStar::bin_of(const PlanarPose& pose) const {
  const auto column = std::clamp(static_cast<int>((pose.x - area_.min.x()) / options_.bin_m), 0, columns_ - 1);
  const auto row = std::clamp(static_cast<int>((pose.y - area_.min.y()) / options_.bin_m), 0, rows_ - 1);
  const int heading = static_cast<int>(std::lround(pose.heading / (2 * kPi) * kHeadings)) & (kHeadings - 1);
  return {column, row, heading};
}

std::uint32_t IntervalAStar::node_near(const PlanarPose& pose) const {
  const auto [column, row, heading] = bin_of(pose);
  return bins_.find(column, row, heading);
}

/// By a label of a bin, the last of which is `in_bin`.
bool IntervalAStar::is_dominated(std::uint32_t in_bin, double cost, const AltitudeLabel& label) const {
  const double weight = cost_->climb_weight();
  int count = 0;
  for (std::uint32_t i = in_bin; i != kNone; i = nodes_[i].next_in_bin, ++count) {
    const Node& other = nodes_[i];
    const bool cheaper =
        !options_.by_cost || other.cost + weight * other.label.ascent_to(std::max(other.label.low, label.free)) <=
                                 cost + weight * label.ascent;
    const bool wider =
        other.label.low <= label.low + options_.alike_m && other.label.high >= label.high - options_.alike_m;
    if (wider && cheaper) return true;
  }
  constexpr int kMostLabels = 8;
  return count >= kMostLabels;
}

/// Is a label dead or dominated however well the way to `next` may turn out, so that it need not be walked?
bool IntervalAStar::is_hopeless(const Node& at, const PlanarPose& next, double length_m) const {
  AltitudeLabel best = at.label;
  best.advance(length_m, cost_->band().slopes());
  const auto [floor, ceiling] = cost_->band().open_at(next.position());
  best.low = std::max(best.low, floor);
  best.high = std::min(best.high, ceiling);
  return !best.alive() || is_dominated(node_near(next), at.cost + cost_->length_weight() * length_m, best);
}

/// The node added; kNone where it is of no use.
std::uint32_t IntervalAStar::add(const Node& node) {
  const double rest_cost = rest(node);
  if (!std::isfinite(rest_cost)) return kNone;
  const auto [column, row, heading] = bin_of(node.pose);
  std::uint32_t& bin = bins_.at(column, row, heading);
  if (is_dominated(bin, node.cost, node.label)) return kNone;
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  open_.push_back({node.cost + options_.epsilon * rest_cost, index});
  std::ranges::push_heap(open_, std::greater{});
  nodes_.push_back(node);
  nodes_.back().next_in_bin = bin;
  bin = index;
  return index;
}

/// Along its piece; false where no altitude is left.
bool IntervalAStar::advance(Node& node) const {
  node.cost += cost_->advance(node.piece, node.label);
  return std::isfinite(node.cost);
}

void IntervalAStar::expand(std::uint32_t from) {
  for (const TwoPieces& primitive : primitives_) expand(from, primitive);
}

void IntervalAStar::expand(std::uint32_t from, const TwoPieces& primitive) {
  const double radius = cost_->band().radius_m();
  const Node at = nodes_[from];
  const PlanarPose middle = moved(at.pose, primitive.first);
  const PlanarPose last = moved(middle, primitive.second);
  const bool is_short_hopeless = is_hopeless(at, middle, primitive.first_m);
  const bool is_long_hopeless = is_hopeless(at, last, primitive.first_m + primitive.second_m);
  if (is_short_hopeless && is_long_hopeless) return;
  Node first{.piece = {primitive.steering, at.pose, primitive.first_m, radius},
             .pose = middle,
             .label = at.label,
             .cost = at.cost,
             .parent = from};
  if (!advance(first)) return;
  std::uint32_t parent = is_short_hopeless ? kNone : add(first);
  if (is_long_hopeless) return;
  Node second{.piece = {primitive.steering, middle, primitive.second_m, radius},
              .pose = last,
              .label = first.label,
              .cost = first.cost};
  if (!advance(second)) return;
  if (parent == kNone) {
    // Only passed through.
    parent = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(first);
  }
  second.parent = parent;
  add(second);
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
  const double radius = cost_->band().radius_m();
  const auto primitive = [&](Steering steering, double first_m, double second_m) {
    return TwoPieces{.steering = steering,
                     .first_m = first_m,
                     .second_m = second_m,
                     .first = planar_motion(steering, first_m, radius),
                     .second = planar_motion(steering, second_m, radius)};
  };
  const double arc = radius * kPi / 8;
  primitives_ = {primitive(left, arc, arc), primitive(right, arc, arc),
                 primitive(straight, options_.bin_m, 2 * options_.bin_m)};
  for (const PlanarPose& pose : start.poses) add({.pose = pose, .label = start.label});
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
    if (options_.shoots && until_shot_-- == 0) {
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
