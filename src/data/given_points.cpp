#include "data/given_points.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace alate {

bool GivenPoints::insert_id(int id) {
  const auto index = static_cast<std::size_t>(id);
  if (index >= ids_.size()) ids_.resize(std::max(index + 1, 2 * ids_.size()));
  if (ids_[index]) return false;
  ids_[index] = true;
  return true;
}

std::optional<PointFault> GivenPoints::add(const GivenPoint& given) {
  const CorrectionPoint& point = given.point;
  if (!insert_id(point.id))
    return PointFault{.field = "id", .value = fmt::format("{}", point.id), .message = "another point has this id"};
  if (point.kind == PointKind::vertical || point.kind == PointKind::horizontal) {
    points_.push_back(given);
    return std::nullopt;
  }
  const bool begins = point.kind == PointKind::start;
  auto& end = begins ? start_ : end_;
  if (end) {
    return PointFault{.field = "kind",
                      .value = begins ? "start" : "end",
                      .limit = fmt::format("one {}", begins ? "start" : "end"),
                      .message = fmt::format("point {} is that already", end->point.id)};
  }
  end = given;
  return std::nullopt;
}

std::optional<PointFault> GivenPoints::missing_end() const {
  if (start_.has_value() == end_.has_value()) return std::nullopt;
  return PointFault{.limit = "one start and one end, or neither",
                    .message = start_ ? "the points have a start but no end" : "the points have an end but no start"};
}

}  // namespace alate
