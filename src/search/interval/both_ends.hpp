// The search from both ends at once. One that is caught in a valley with no way out, or that finds a goal which can be
// come to from the far side only, must fill all of the trap; from the other end the same way is easy to find.
#pragma once

#include "search/interval/interval_astar.hpp"

namespace alate {

/// A second search leads from the goal back, as flights the other way do. Where one of them comes near a place where
/// the other has been, a shortest way between the two that keeps the band makes them one. A search that has nothing
/// left begins anew with bins half as wide: it may be in a pocket whose way out they hid.
class BothEnds {
 public:
  /// `out` searches from the start; `to_start` guides from the goal back there. All must outlive this. No bins become
  /// narrower than `least_bin_m`.
  BothEnds(IntervalAStar& out, const FlightCost& cost, const ClimbField& to_start, double least_bin_m);
  BothEnds(const BothEnds&) = delete;
  BothEnds& operator=(const BothEnds&) = delete;

  /// A track whose labels all live, from the start to the end; nothing if none was found.
  std::optional<Track> find(const FlightStart& start, const FlightEnd& end, const IntervalSearchOptions& options,
                            RunContext& run);

  /// Of both searches.
  std::uint64_t expansions() const { return expansions_; }

 private:
  /// One of the searches.
  struct End {
    IntervalAStar& search;
    FlightStart start;
    FlightEnd end;
    IntervalSearchOptions options;

    void begin() { search.begin(start, end, options); }
    bool go_on_narrower(double least_bin_m);
  };
  std::optional<Track> step(End& one, const End& other, RunContext& run);
  std::optional<Track> join_near(const End& one, std::uint32_t node, const End& other) const;
  std::optional<Track> join(std::uint32_t first, std::uint32_t second) const;

  IntervalAStar& out_;
  BandWalk band_;
  FlightCost cost_;
  IntervalAStar back_;
  double least_bin_m_;
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
