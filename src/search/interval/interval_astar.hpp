// The first way over the ground: weighted A* over true Dubins pieces, each label an interval of altitudes.
//
// A node is a pose and an AltitudeLabel; a pass through a bin of place and heading is dropped where another one came
// there cheaper with at least its altitudes. Guided by a cost-to-go that knows climbing (ClimbField).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"
#include "search/interval/bin_pages.hpp"
#include "space/flight/climb_field.hpp"
#include "space/flight/flight_cost.hpp"

namespace alate {

/// Where the flight may end: in the goal's ball, of which `tilt_rad` tells how much is spent on altitude. From the side
/// the flight ends on the upright chord of the ball that is seen at this angle above and below its middle.
struct FlightEnd {
  Vec3 goal;
  double tolerance_m = 0;
  double tilt_rad = kPi / 4;

  Vec2 place() const { return goal.head<2>(); }
  double radius_m() const { return tolerance_m * std::cos(tilt_rad); }
  double low() const { return goal.z() - tolerance_m * std::sin(tilt_rad); }
  double high() const { return goal.z() + tolerance_m * std::sin(tilt_rad); }
};

/// Where it begins: at one of these poses and altitudes.
struct FlightStart {
  std::vector<PlanarPose> poses;
  AltitudeLabel label;
};

/// Where any heading will do: one for each that bins tell apart, the first of them towards a place.
std::vector<PlanarPose> any_heading(const Vec2& at, const Vec2& towards);

struct IntervalSearchOptions {
  double epsilon = 2.5;  ///< How much the cost-to-go weighs.
  double bin_m = 100;
  std::uint64_t most_nodes = 1'000'000;
  /// A label is dropped where another one in its bin has its altitudes, but for so many metres.
  double alike_m = 1.5;
  /// Does it take one that is cheaper to drop another? Otherwise the first one stays: where any way will do.
  bool by_cost = true;
  bool shoots = true;  ///< Are shortest ways to the end tried?
};

/// Keeps its arrays between searches: nodes, bins and queue. Not for two threads at once.
class IntervalAStar {
 public:
  /// All must outlive this, or the last search before `turn_to`.
  IntervalAStar(const FlightCost& cost, const ClimbField& to_go);

  /// From now on searches another world, or by another guide.
  void turn_to(const FlightCost& cost, const ClimbField& to_go);

  /// A track whose labels all live, to the end; nothing if none was found.
  std::optional<Track> find(const FlightStart& start, const FlightEnd& end, const IntervalSearchOptions& options,
                            RunContext& run);

  /// The same bit by bit: from here on `go_on` searches.
  void begin(const FlightStart& start, const FlightEnd& end, const IntervalSearchOptions& options);
  /// For at most so many expansions.
  std::optional<Track> go_on(std::uint64_t most_expansions, RunContext& run);
  /// Is there nothing left to expand, or no node left for it?
  bool exhausted() const { return open_.empty() || nodes_.size() >= options_.most_nodes; }

  /// Since the search began.
  std::uint64_t expansions() const { return expansions_; }

  static constexpr std::uint32_t kNone = BinPages::kNone;
  /// How far it has come.
  struct Node {
    PlanarPiece piece;  ///< That led here.
    PlanarPose pose;
    AltitudeLabel label;
    double cost = 0;  ///< Without ascent.
    std::uint32_t parent = kNone;
    std::uint32_t next_in_bin = kNone;
  };
  const std::vector<Node>& nodes() const { return nodes_; }
  /// The last node that came to the bin of a place and heading; kNone if none did.
  std::uint32_t node_near(const PlanarPose& pose) const;
  Track track_to(std::uint32_t node) const;

 private:
  struct Bin {
    int column, row, heading;
  };
  /// A piece and one more of the same kind that goes on from its end.
  struct TwoPieces {
    Steering steering;
    double first_m, second_m;
    PlanarMotion first, second;
  };
  struct Open {
    double key;
    std::uint32_t node;
    bool operator>(const Open& other) const { return key != other.key ? key > other.key : node > other.node; }
  };

  Open pop_open();
  void expand(std::uint32_t from);
  void expand(std::uint32_t from, const TwoPieces& primitive);
  bool advance(Node& node) const;
  std::uint32_t add(const Node& node);
  bool is_dominated(std::uint32_t in_bin, double cost, const AltitudeLabel& label) const;
  bool is_hopeless(const Node& at, const PlanarPose& next, double length_m) const;
  Bin bin_of(const PlanarPose& pose) const;
  double rest(const Node& node) const;
  std::optional<Track> shot(std::uint32_t from) const;

  const FlightCost* cost_;
  const ClimbField* to_go_;
  IntervalSearchOptions options_;
  FlightEnd end_;
  Box2 area_;
  int columns_ = 0;
  int rows_ = 0;
  BinPages bins_;  ///< The last node that came to each.
  std::vector<Node> nodes_;
  std::array<TwoPieces, 3> primitives_{};
  std::vector<Open> open_;  ///< A heap, the least key in front.
  std::uint64_t expansions_ = 0;
  std::uint64_t until_shot_ = 0;
};

/// Cuts a track that leads to the middle of an end where it comes near enough.
void cut_at_end(Track& track, const FlightEnd& end);

}  // namespace alate
