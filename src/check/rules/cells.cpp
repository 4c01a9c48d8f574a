#include <algorithm>

#include "check/cell_passage.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

/// Counts the places of one flight at which blocked cells are touched.
template <class Map>
class Touches {
 public:
  static constexpr int kAxes = Map::kAxes;
  using Place = CellPlace<kAxes>;

  Touches(Map map, const Vec3& start) : map_(map), walk_(map, start.head<kAxes>()) {}

  void begin_leg() { count_ = 0; }
  void fly(const Vec3& to) {
    for (const Stretch<kAxes>& stretch : walk_.advance(to.head<kAxes>())) pass(stretch);
  }
  /// For a flight that never left its place.
  void stand() {
    if (!moved_ && is_blocked(map_, walk_.here())) touch(walk_.here().middle);
  }
  bool any() const { return count_ > 0; }
  Finding finding(std::size_t leg, const Vec3& otherwise) const {
    Finding finding{.leg = leg, .where = otherwise, .value = static_cast<double>(count_), .limit = 0, .unit = "places"};
    if (count_ > 0) finding.where.head<kAxes>() = where_;
    return finding;
  }

 private:
  void pass(const Stretch<kAxes>& stretch) {
    const bool free = free_cell(map_, stretch) != nullptr;
    if (is_blocked(map_, stretch)) touch(stretch.middle);
    if (free && came_free_ && !connects(map_, last_, stretch)) touch(stretch.begin);
    last_ = stretch;
    came_free_ = free;
    moved_ = true;
  }
  void touch(const Place& at) {
    if (count_++ == 0) where_ = at;
  }

  Map map_;
  CellPassage<Map> walk_;
  Stretch<kAxes> last_;
  bool came_free_ = false;  ///< `last_` has a free cell.
  bool moved_ = false;
  std::size_t count_ = 0;
  Place where_ = Place::Zero();
};

template <class Map>
void judge_cells(const Flight& flight, Map map, RuleReport& report) {
  Touches<Map> touches(map, flight.route.states.front().position);
  for (const Leg& leg : flight.legs) {
    touches.begin_leg();
    for (const Segment& piece : leg.pieces) touches.fly(piece.b);
    if (&leg == &flight.legs.back()) touches.stand();
    if (touches.any() || !flight.site.has_ground()) report.at_most(touches.finding(leg.index, leg.pieces.back().b));
  }
}

}  // namespace

void judge_blocked_cells(const Flight& flight, RuleReport& report) {
  if (flight.legs.empty()) return;
  if (flight.site.grid) judge_cells(flight, FlatCells{*flight.site.grid}, report);
  if (flight.site.voxels) judge_cells(flight, SpaceCells{*flight.site.voxels}, report);
}

}  // namespace alate
