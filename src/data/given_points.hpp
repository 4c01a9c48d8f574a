// Correction points as they were given, before they are brought into the frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/data/site.hpp"

namespace alate {

/// One point of a file or a list.
struct GivenPoint {
  CorrectionPoint point;    ///< Position: metres of the frame, or lat, lon (degrees) and height above sea level.
  bool geographic = false;  ///< Which of the two.
  int row = 0;              ///< Line of the file, or place in the list from 0.
};

/// What keeps a point, or the ends of the flight, from being taken.
struct PointFault {
  std::string field;  ///< "id", "kind"; empty for the points as a whole.
  std::string value;
  std::string limit;
  std::string message;
};

/// Points in their order, the ends of the flight apart. Every id stands once, every end at most once.
class GivenPoints {
 public:
  /// Nothing if the point was taken. Ids are 0 to kMaxPointId.
  std::optional<PointFault> add(const GivenPoint& given);

  // The parts of `add`, for points of which not every part can be read: a fault in one must not hide those in others.
  std::optional<PointFault> claim_id(int id);
  /// `id`: what a second end is told of the first.
  std::optional<PointFault> claim_kind(PointKind kind, std::optional<int> id);
  void take(const GivenPoint& given);

  /// Both ends or neither? Asked when all points were added.
  std::optional<PointFault> missing_end() const;

  const std::vector<GivenPoint>& points() const { return points_; }
  const std::optional<GivenPoint>& start() const { return start_; }
  const std::optional<GivenPoint>& end() const { return end_; }

 private:
  /// An end that was claimed, whether or not it was taken.
  struct Claimed {
    bool there = false;
    std::optional<int> id;
  };

  std::vector<GivenPoint> points_;
  std::optional<GivenPoint> start_;
  std::optional<GivenPoint> end_;
  Claimed claimed_start_;
  Claimed claimed_end_;
  std::vector<bool> ids_;  ///< By id: is it there?
};

}  // namespace alate
