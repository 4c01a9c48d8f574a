#include <algorithm>

#include "check/grid_walk.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

/// Counts the places of one flight at which blocked cells are touched.
class Touches {
 public:
  Touches(const HeightGrid& grid, const Vec2& start) : grid_(grid), walk_(grid, start) {}

  void begin_leg() { count_ = 0; }
  void fly(const Vec2& to) {
    for (const Stretch& stretch : walk_.advance(to)) pass(stretch);
  }
  /// For a flight that never left its place.
  void stand() {
    if (!moved_ && is_blocked(grid_, walk_.here())) touch(walk_.here().middle);
  }
  bool any() const { return count_ > 0; }
  Finding finding(std::size_t leg, const Vec3& otherwise) const {
    return {.leg = leg,
            .where = count_ > 0 ? Vec3(where_.x(), where_.y(), otherwise.z()) : otherwise,
            .value = static_cast<double>(count_),
            .limit = 0,
            .unit = "places"};
  }

 private:
  void pass(const Stretch& stretch) {
    const bool free = free_cell(grid_, stretch) != nullptr;
    if (is_blocked(grid_, stretch)) touch(stretch.middle);
    if (free && came_free_ && !connects(grid_, last_, stretch)) touch(stretch.begin);
    last_ = stretch;
    came_free_ = free;
    moved_ = true;
  }
  void touch(const Vec2& at) {
    if (count_++ == 0) where_ = at;
  }

  const HeightGrid& grid_;
  GridPassage walk_;
  Stretch last_;
  bool came_free_ = false;  ///< `last_` has a free cell.
  bool moved_ = false;
  std::size_t count_ = 0;
  Vec2 where_ = Vec2::Zero();
};

}  // namespace

void judge_blocked_cells(const Flight& flight, RuleReport& report) {
  if (flight.legs.empty()) return;
  Touches touches(*flight.site.grid, flight.route.states.front().position.head<2>());
  for (const Leg& leg : flight.legs) {
    touches.begin_leg();
    for (const Segment& piece : leg.pieces) touches.fly(piece.b.head<2>());
    if (&leg == &flight.legs.back()) touches.stand();
    if (touches.any() || !flight.site.has_ground()) report.at_most(touches.finding(leg.index, leg.pieces.back().b));
  }
}

}  // namespace alate
