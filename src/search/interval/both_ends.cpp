#include "search/interval/both_ends.hpp"

#include "space/dubins/dubins_path.hpp"

namespace alate {

BothEnds::BothEnds(IntervalAStar& out, const FlightCost& cost, const ClimbField& to_start, double least_bin_m)
    : out_(out), band_(cost.band().homeward()), cost_(band_), back_(cost_, to_start), least_bin_m_(least_bin_m) {}

std::optional<Track> BothEnds::find(const FlightStart& start, const FlightEnd& end,
                                    const IntervalSearchOptions& options, RunContext& run) {
  End from_start{.search = out_, .start = start, .end = end, .options = options};
  const PlanarPose& first = start.poses.front();
  End from_goal{.search = back_,
                .start = {.poses = any_heading(end.place(), first.position()),
                          .label = {.low = end.low(), .high = end.high(), .ascent = 0, .free = end.high()}},
                .end = {.goal = {first.x, first.y, start.label.low}},
                .options = options};
  from_goal.options.shoots = false;
  from_start.begin();
  from_goal.begin();
  while (run.keep_going()) {
    constexpr int kSteps = 64;
    for (int k = 0; k < kSteps; ++k) {
      if (!from_start.go_on_narrower(least_bin_m_) || !from_goal.go_on_narrower(least_bin_m_)) return std::nullopt;
      if (auto track = step(from_start, from_goal, run)) return track;
      if (auto track = step(from_goal, from_start, run)) return track;
    }
  }
  return std::nullopt;
}

/// Where nothing is left, with bins half as wide; false where they would be too narrow.
bool BothEnds::End::go_on_narrower(double least_bin_m) {
  while (search.exhausted()) {
    options.bin_m /= 2;
    if (options.bin_m < least_bin_m) return false;
    begin();
  }
  return true;
}

/// One expansion.
std::optional<Track> BothEnds::step(End& one, const End& other, RunContext& run) {
  auto node = static_cast<std::uint32_t>(one.search.nodes().size());
  ++expansions_;
  if (auto track = one.search.go_on(1, run)) return track;
  for (; node < one.search.nodes().size(); ++node)
    if (auto track = join_near(one, node, other)) return track;
  return std::nullopt;
}

/// With what the other search has found in the bins ahead.
std::optional<Track> BothEnds::join_near(const End& one, std::uint32_t node, const End& other) const {
  constexpr int kBins = 2;
  constexpr int kLabels = 4;
  const PlanarPose& pose = one.search.nodes()[node].pose;
  for (int bin = 0; bin <= kBins; ++bin) {
    const PlanarPose ahead = moved(pose, planar_motion(Steering::straight, bin * other.options.bin_m, 1));
    std::uint32_t there = other.search.node_near(reversed(ahead));
    for (int k = 0; k < kLabels && there != IntervalAStar::kNone; ++k) {
      if (auto track = &one.search == &out_ ? join(node, there) : join(there, node)) return track;
      there = other.search.nodes()[there].next_in_bin;
    }
  }
  return std::nullopt;
}

/// From a node of the search from the start to one of that from the goal.
std::optional<Track> BothEnds::join(std::uint32_t first, std::uint32_t second) const {
  const IntervalAStar::Node& from = out_.nodes()[first];
  const IntervalAStar::Node& to = back_.nodes()[second];
  const PlanarPose pose = reversed(to.pose);
  const double radius = band_.radius_m();
  // Full circles seldom find room.
  const double most_m = 2 * (pose.position() - from.pose.position()).norm() + radius;
  const SlopeLimits& back = band_.slopes();
  if (from.label.low - most_m * back.climb > to.label.high || from.label.high + most_m * back.descent < to.label.low)
    return std::nullopt;
  const DubinsPath path = shortest_dubins(from.pose, pose, radius);
  if (path.length_m > most_m) return std::nullopt;
  Track between;
  append(between, path);
  AltitudeLabel label = to.label;
  for (std::size_t k = between.size(); k-- > 0;)
    if (between[k].length_m < kLeastPiece_m || !band_.advance(reversed(between[k]), label)) return std::nullopt;
  if (label.low > from.label.high || label.high < from.label.low) return std::nullopt;
  Track track = out_.track_to(first);
  track.insert(track.end(), between.begin(), between.end());
  const Track home = back_.track_to(second);
  for (std::size_t k = home.size(); k-- > 0;) track.push_back(reversed(home[k]));
  return track;
}

}  // namespace alate
