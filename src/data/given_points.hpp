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

  /// Both ends or neither? Asked when all points were added.
  std::optional<PointFault> missing_end() const;

  const std::vector<GivenPoint>& points() const { return points_; }
  const std::optional<GivenPoint>& start() const { return start_; }
  const std::optional<GivenPoint>& end() const { return end_; }

 private:
  /// False if it was there already.
  bool insert_id(int id);

  std::vector<GivenPoint> points_;
  std::optional<GivenPoint> start_;
  std::optional<GivenPoint> end_;
  std::vector<bool> ids_;  ///< By id: is it there?
};

}  // namespace alate
