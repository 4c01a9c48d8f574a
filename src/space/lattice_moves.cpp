#include "space/lattice_moves.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "space/sure_leg.hpp"

namespace alate {

namespace {

/// Metres by which rounding may miss a limit; World forgives more.
constexpr double kHair_m = 1e-7;
constexpr double kHair_rad = 1e-9;

constexpr bool holds(unsigned set, unsigned move) { return ((set >> move) & 1U) != 0; }

}  // namespace

LatticeFaults& LatticeFaults::operator+=(const LatticeFaults& other) {
  length += other.length;
  leg += other.leg;
  height += other.height;
  pitch += other.pitch;
  turn += other.turn;
  collision += other.collision;
  return *this;
}

LatticeMoves::LatticeMoves(const World& world, const LatticeFrame& frame, const LatticeRules& rules, RunContext& run)
    : world_(world),
      frame_(frame),
      rules_(rules),
      aircraft_(world.site()),
      asks_each_leg_(world.site().band.ceiling_agl_m ||
                     std::ranges::any_of(world.site().threats, [](const Threat& t) { return t.core_m > 0; })),
      slack_m_(hill_slack_m(world.site())),
      open_(frame.nodes()),
      clear_(frame.nodes()),
      joins_(frame.plane_size()),
      reached_(frame.nodes()),
      first_of_last_(frame.nodes() - frame.plane_size()) {
  note_shapes();
  if (!flood(run)) {
    stopped_ = true;
    return;
  }
  note_joins(run);
  find_dead_ends();
  count_barred();
}

bool LatticeMoves::is_short(const Vec3& leg) const { return leg.norm() < rules_.limits.leg_m - kHair_m; }

bool LatticeMoves::is_steep(const Vec3& leg) const {
  return std::abs(climb_angle({Vec3::Zero(), leg})) > rules_.limits.pitch_rad + kHair_rad;
}

bool LatticeMoves::is_sharp(const Vec3& before, const Vec3& after) const {
  return turn_between(before, after) > rules_.limits.turn_rad + kHair_rad;
}

bool LatticeMoves::is_high_or_low(const Place& at) const {
  const double z = frame_.position(at).z();
  return z > rules_.limits.height_amsl_m + kHair_m || z < frame_.ground(at) + rules_.limits.height_agl_m - kHair_m;
}

void LatticeMoves::note_shapes() {
  const auto& shifts = frame_.shifts();
  for (unsigned m = 0; m < frame_.moves(); ++m) {
    const Vec3& leg = shifts[m].leg;
    if (!aircraft_.allows(leg) || (rules_.filters && (is_short(leg) || is_steep(leg)))) continue;
    shapes_ |= 1U << m;
    if (aircraft_.allows_first(leg)) follows_[LatticeFrame::kFirst] |= 1U << m;
  }
  for (unsigned before = 0; before < frame_.moves(); ++before)
    for (unsigned after = 0; after < frame_.moves(); ++after)
      if (aircraft_.allows_corner(shifts[before].leg, shifts[after].leg) &&
          !(rules_.filters && is_sharp(shifts[before].leg, shifts[after].leg)))
        follows_[before] |= 1U << after;
}

/// Plane by plane; columns of a plane at the same time, each writes its own nodes.
bool LatticeMoves::flood(RunContext& run) {
  reached_[frame_.start()] = 1;
  std::atomic<bool> goes_on = run.keep_going();
  for (int plane = 0; plane + 1 < frame_.planes() && goes_on; ++plane) {
    run.executor().for_ranges(static_cast<std::size_t>(frame_.columns()), [&](std::size_t begin, std::size_t end) {
      for (std::size_t column = begin; column < end && goes_on; ++column) {
        open_column(plane, static_cast<int>(column));
        if (!run.keep_going()) goes_on = false;
      }
    });
    const Node first = frame_.node({plane, 0, 0});
    for (Node node = first; node < first + frame_.plane_size(); ++node) {
      if (open_[node] != 0) last_plane_ = plane + 1;
      for (unsigned open = open_[node]; open != 0; open &= open - 1)
        reached_[frame_.after(node, static_cast<unsigned>(std::countr_zero(open)))] = 1;
    }
  }
  return goes_on;
}

void LatticeMoves::open_column(int plane, int column) {
  const auto first = reached_.begin() + frame_.node({plane, column, 0});
  if (std::ranges::none_of(first, first + frame_.levels(), [](std::uint8_t reached) { return reached != 0; })) return;
  for (unsigned move = 0; move < frame_.moves(); ++move) {
    const LatticeFrame::Shift& shift = frame_.shifts()[move];
    const int to = column + shift.side;
    if (!holds(shapes_, move) || to < 0 || to >= frame_.columns()) continue;
    const Segment lowest{frame_.position({plane, column, 0}), frame_.position({plane + 1, to, shift.height})};
    const double missing = world_.site().band.clearance_m + slack_m_ - kHair_m - world_.clearance(lowest);
    const double level =
        std::clamp(std::ceil(missing / frame_.steps_m().z()), 0.0, static_cast<double>(frame_.levels()));
    open_move({.plane = plane, .column = column, .move = move, .lowest = static_cast<unsigned>(level)});
  }
}

bool LatticeMoves::is_free(const ColumnMove& what, int level) const {
  if (level < static_cast<int>(what.lowest)) return false;
  if (!asks_each_leg_) return true;
  const LatticeFrame::Shift& shift = frame_.shifts()[what.move];
  return is_surely_free(world_, {frame_.position({what.plane, what.column, level}),
                                 frame_.position({what.plane + 1, what.column + shift.side, level + shift.height})});
}

void LatticeMoves::open_move(const ColumnMove& what) {
  const LatticeFrame::Shift& shift = frame_.shifts()[what.move];
  const int lowest = rules_.whole_legs ? static_cast<int>(what.lowest) : 0;
  const int first = std::max(lowest, -shift.height);
  const int last = std::min(frame_.levels(), frame_.levels() - shift.height);
  for (int level = first; level < last; ++level) {
    const Node node = frame_.node({what.plane, what.column, level});
    const Place to{what.plane + 1, what.column + shift.side, level + shift.height};
    if (reached_[node] == 0 || !is_safe(to) || (rules_.filters && is_high_or_low(to))) continue;
    const bool clear = is_free(what, level);
    if (clear) clear_[node] |= 1U << what.move;
    if (clear || !rules_.whole_legs) open_[node] |= 1U << what.move;
  }
}

/// S of eq. (11) and the scenario's band at a node; unknown ground is not safe.
bool LatticeMoves::is_safe(const Place& at) const {
  const Band& band = world_.site().band;
  const double z = frame_.position(at).z();
  const double above = z - frame_.ground(at);
  const bool too_far_above = band.ceiling_agl_m && above > *band.ceiling_agl_m + kHair_m;
  const bool too_high = band.ceiling_amsl_m && z > *band.ceiling_amsl_m + kHair_m;
  return above >= std::max(band.clearance_m, rules_.safe_agl_m) - kHair_m && !too_far_above && !too_high;
}

void LatticeMoves::note_joins(const RunContext& run) {
  run.executor().for_ranges(frame_.plane_size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (const Node node = first_of_last_ + static_cast<Node>(i); reached_[node] != 0) joins_[i] = joins_from(node);
  });
}

unsigned LatticeMoves::joins_from(Node node) const {
  const Vec3 from = frame_.position(node);
  const Vec3 leg = frame_.goal() - from;
  if (!rules_.any_join && !frame_.goal_in_window(from)) return 0;
  if (!aircraft_.allows(leg) || (rules_.filters && (is_short(leg) || is_steep(leg)))) return 0;
  if (!is_surely_free(world_, {from, frame_.goal()})) return 0;
  unsigned after = aircraft_.allows_first(leg) ? 1U << LatticeFrame::kFirst : 0;
  for (unsigned came = 0; came < frame_.moves(); ++came) {
    const Vec3& before = frame_.shifts()[came].leg;
    if (aircraft_.allows_corner(before, leg) && !(rules_.filters && is_sharp(before, leg))) after |= 1U << came;
  }
  return after;
}

void LatticeMoves::find_dead_ends() {
  std::vector<std::uint8_t> arrives(frame_.nodes());
  for (Node i = 0; i < frame_.plane_size(); ++i) arrives[first_of_last_ + i] = joins_[i] != 0 ? 1 : 0;
  const bool one_leg = first_of_last_ == 0;
  if (one_leg) arrives[frame_.start()] = holds(joins_[frame_.start()], LatticeFrame::kFirst) ? 1 : 0;
  for (Node node = first_of_last_; node-- > 0;) {
    unsigned alive = 0;
    for (unsigned open = open_[node]; open != 0; open &= open - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(open));
      const Node to = frame_.after(node, move);
      if (arrives[to] != 0 && (to < first_of_last_ || holds(joins(to), move))) alive |= 1U << move;
    }
    arrives[node] = alive != 0 ? 1 : 0;
    if (rules_.prunes) open_[node] = alive;
  }
  has_way_ = arrives[frame_.start()] != 0;
}

void LatticeMoves::count_barred() {
  if (!rules_.filters) return;
  std::uint64_t reached = 0;
  for (int plane = 0; plane < frame_.planes(); ++plane)
    for (int column = 0; column < frame_.columns(); ++column)
      for (int level = 0; level < frame_.levels(); ++level) {
        const Place at{plane, column, level};
        reached += reached_[frame_.node(at)];
        barred_.height += is_safe(at) && is_high_or_low(at) ? 1U : 0U;
      }
  const auto& shifts = frame_.shifts();
  for (const LatticeFrame::Shift& one : shifts) {
    barred_.leg += is_short(one.leg) ? reached : 0;
    barred_.pitch += is_steep(one.leg) ? reached : 0;
    for (const LatticeFrame::Shift& next : shifts) barred_.turn += is_sharp(one.leg, next.leg) ? 1U : 0U;
  }
}

}  // namespace alate
