#include "space/lattice_score.hpp"

#include <algorithm>
#include <bit>

namespace alate {

namespace {

constexpr double kKm = 1000;

}  // namespace

LatticeScore::LatticeScore(const World& world, const LatticeFrame& frame, const LatticeMoves& moves,
                           const TerrainScore& rule)
    : frame_(frame), rule_(rule), objective_(world.site().scenario.objective), of_join_(frame.plane_size()) {
  for (unsigned m = 0; m < frame.moves(); ++m) {
    const Vec3& leg = frame.shifts()[m].leg;
    length_m_[m] = leg.norm();
    of_step_[LatticeFrame::kFirst][m] = of_length(leg);
    for (unsigned came = 0; came < frame.moves(); ++came)
      of_step_[came][m] = of_length(leg) + of_angle(frame.shifts()[came].leg, leg);
  }
  if (rule_.is_papers() && rule_.height != 0) note_heights();
  if (!rule_.is_papers() && !world.site().threats.empty()) note_exposures(world, moves);
  note_joins(world, moves);
}

double LatticeScore::of_length(const Vec3& leg) const {
  if (rule_.is_papers()) return rule_.length * leg.norm() / kKm;  // eq. (21)
  return objective_.length * leg.norm() + objective_.climb * std::max(0.0, leg.z());
}

/// Eq. (23).
double LatticeScore::of_angle(const Vec3& before, const Vec3& after) const {
  if (!rule_.is_papers()) return 0;
  const double angle = angle_between(before, after);
  return rule_.turn * (rule_.degrees ? degrees(angle) : angle);
}

/// Eq. (22).
void LatticeScore::note_heights() {
  of_height_.resize(frame_.nodes());
  for (int plane = 0; plane < frame_.planes(); ++plane) {
    for (int column = 0; column < frame_.columns(); ++column) {
      const double datum = rule_.datum == TerrainScore::Datum::ground ? frame_.ground({plane, column, 0}) : 0;
      for (int level = 0; level < frame_.levels(); ++level) {
        const double height = frame_.position({plane, column, level}).z() - datum;
        float& of_height = of_height_[frame_.node({plane, column, level})];
        of_height = static_cast<float>(rule_.height * height / kKm);
        least_of_end_ = std::min(least_of_end_, double{of_height});
      }
    }
  }
}

void LatticeScore::note_exposures(const World& world, const LatticeMoves& moves) {
  exposed_.resize(kRow * frame_.nodes());
  for (Node node = 0; node < frame_.nodes(); ++node) {
    if (moves.open(node) == 0) continue;
    const Vec3 from = frame_.position(node);
    for (unsigned open = moves.open(node); open != 0; open &= open - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(open));
      const double exposure = world.exposure({from, from + frame_.shifts()[move].leg});
      exposed_[kRow * node + move] = static_cast<float>(objective_.threat * exposure);
    }
  }
}

void LatticeScore::note_joins(const World& world, const LatticeMoves& moves) {
  const Node first = frame_.nodes() - frame_.plane_size();
  const double ground = world.height(frame_.goal().head<2>()).value_or(0);
  const double datum = rule_.datum == TerrainScore::Datum::ground ? ground : 0;
  const double at_goal = rule_.height * (frame_.goal().z() - datum) / kKm;
  for (Node node = first; node < frame_.nodes(); ++node) {
    if (moves.joins(node) == 0) continue;
    const Segment leg{frame_.position(node), frame_.goal()};
    double& cost = of_join_[node - first];
    cost = of_length(leg.b - leg.a);
    if (!rule_.is_papers()) {
      cost += objective_.threat * world.exposure(leg);
    } else if (!of_height_.empty()) {
      cost += at_goal;
      least_of_end_ = std::min(least_of_end_, at_goal);
    }
  }
}

double LatticeScore::of_join(Node node, unsigned came) const {
  const double straight = of_join_[node - (frame_.nodes() - frame_.plane_size())];
  if (!rule_.is_papers() || came == LatticeFrame::kFirst || rule_.turn == 0) return straight;
  return straight + of_angle(frame_.shifts()[came].leg, frame_.goal() - frame_.position(node));
}

}  // namespace alate
