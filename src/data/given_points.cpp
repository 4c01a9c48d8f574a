#include "data/given_points.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace alate {

std::optional<PointFault> GivenPoints::claim_id(int id) {
  const auto index = static_cast<std::size_t>(id);
  if (index >= ids_.size()) ids_.resize(std::max(index + 1, 2 * ids_.size()));
  if (ids_[index])
    return PointFault{.field = "id", .value = fmt::format("{}", id), .message = "another point has this id"};
  ids_[index] = true;
  return std::nullopt;
}

std::optional<PointFault> GivenPoints::claim_kind(PointKind kind, std::optional<int> id) {
  if (kind == PointKind::vertical || kind == PointKind::horizontal) return std::nullopt;
  const bool begins = kind == PointKind::start;
  Claimed& end = begins ? claimed_start_ : claimed_end_;
  if (end.there) {
    return PointFault{
        .field = "kind",
        .value = begins ? "start" : "end",
        .limit = fmt::format("one {}", begins ? "start" : "end"),
        .message = end.id ? fmt::format("point {} is that already", *end.id) : "another point is that already"};
  }
  end = {.there = true, .id = id};
  return std::nullopt;
}

void GivenPoints::take(const GivenPoint& given) {
  switch (given.point.kind) {
    case PointKind::start:
      start_ = given;
      return;
    case PointKind::end:
      end_ = given;
      return;
    case PointKind::vertical:
    case PointKind::horizontal:
      points_.push_back(given);
  }
}

std::optional<PointFault> GivenPoints::add(const GivenPoint& given) {
  if (auto fault = claim_id(given.point.id)) return fault;
  if (auto fault = claim_kind(given.point.kind, given.point.id)) return fault;
  take(given);
  return std::nullopt;
}

std::optional<PointFault> GivenPoints::missing_end() const {
  if (claimed_start_.there == claimed_end_.there) return std::nullopt;
  return PointFault{
      .limit = "one start and one end, or neither",
      .message = claimed_start_.there ? "the points have a start but no end" : "the points have an end but no start"};
}

}  // namespace alate
