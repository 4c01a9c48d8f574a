// A way that is bettered piece by piece: poses, the Dubins paths between them, and at every pose the altitudes that the
// start allows and those that the goal asks for. So the cost of a local change, ascent included, is exact after
// advancing the changed pieces alone.
#pragma once

#include <array>
#include <vector>

#include "alate/core/stream.hpp"
#include "search/interval/interval_astar.hpp"

namespace alate {

class FlightPath {
 public:
  /// A track from `find`. `cost` must outlive this.
  FlightPath(const FlightCost& cost, FlightEnd end, const Track& track, double z);

  /// Cost as far as it is known before the altitudes are chosen; far more where it may be longer than the range.
  double cost() const { return total_; }
  bool keeps_range() const { return over_range_with({}, {}) <= 0; }
  Track track() const;
  const FlightEnd& end() const { return end_; }

  /// Shortcuts from every pose as far as the way gets cheaper.
  void shorten(RunContext& run);
  /// Random changes, each kept where it makes the way cheaper, or simpler at the same cost. How many were.
  int better(Stream& random, int trials, RunContext& run);

 private:
  struct Leg {
    Track track;
    double cost = 0;              ///< Without ascent.
    bool is_forward_old = true;   ///< Another label has come to its begin,
    bool is_backward_old = true;  ///< or to its end, since it was carried along the leg.
  };
  struct Change {
    std::size_t from = 0, to = 0;  ///< Poses before and after what is changed.
    std::vector<PlanarPose> between;
  };

  bool try_change(const Change& change);
  bool make_leg(const PlanarPose& from, const PlanarPose* to, Leg& leg) const;
  void note_forward(std::size_t to);
  void note_backward(std::size_t from);
  void set_forward(std::size_t at, const AltitudeLabel& label);
  void note_all();
  void split(Stream& random);
  double over_range_with(const Change& change, const std::vector<Leg>& legs) const;
  bool take_if(const Change& change, std::vector<Leg> legs, double most);
  void note_end();
  bool retilt(Stream& random);
  bool move_some(Stream& random);
  std::vector<PlanarPose> moved_poses(std::size_t k, std::size_t count, double size, Stream& random) const;

  const FlightCost* cost_;
  FlightEnd end_;
  std::vector<PlanarPose> poses_;       ///< The start, then one before each further leg.
  std::vector<Leg> legs_;               ///< Leg i begins at pose i; the last ends where the flight does.
  std::vector<AltitudeLabel> forward_;  ///< At pose i, and at the end; old behind legs whose own are.
  std::vector<BackwardLabel> backward_;
  static constexpr double kLeastChance = 0.02;
  std::array<double, 8> size_chances_{0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3};  ///< Of moves, by what they brought.
  double least_climb_ = 0;  ///< Cost of the ascent between the ends.
  double total_ = 0;
};

}  // namespace alate
