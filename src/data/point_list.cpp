#include "data/point_list.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>

#include "alate/core/fault.hpp"
#include "data/limits.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

constexpr std::size_t kNearest = 3;

/// The ids nearest to one that is not there.
std::vector<int> nearest_ids(const std::vector<CorrectionPoint>& points, int id) {
  std::vector<int> ids;
  for (const CorrectionPoint& point : points) ids.push_back(point.id);
  const auto count = static_cast<std::ptrdiff_t>(std::min(kNearest, ids.size()));
  std::ranges::partial_sort(ids, ids.begin() + count, {},
                            [id](int other) { return std::pair(std::abs(other - id), other); });
  ids.resize(static_cast<std::size_t>(count));
  return ids;
}

class ListReader {
 public:
  ListReader(const Navigation& navigation, std::string source) : navigation_(navigation), source_(std::move(source)) {}

  /// Nothing, with a fault, where `word` names no point. `place` counts from 1.
  std::optional<int> read(std::string_view word, int place) {
    if (word.empty()) {
      refuse(place, {.value = "nothing", .message = "an id is missing beside a comma"});
      return std::nullopt;
    }
    int id = 0;
    const char* end = std::to_address(word.end());
    const auto [stopped, error] = std::from_chars(std::to_address(word.begin()), end, id);
    if (error != std::errc{} || stopped != end || id < 0 || id > kMaxPointId) {
      refuse(place, {.value = shortened(std::string(word)),
                     .limit = fmt::format("0 to {}", kMaxPointId),
                     .message = "is not the id of a point"});
      return std::nullopt;
    }
    const auto& points = navigation_.points;
    if (std::ranges::find(points, id, &CorrectionPoint::id) != points.end()) return id;
    refuse(place, {.value = fmt::format("{}", id),
                   .limit = fmt::format("nearest ids: {}", fmt::join(nearest_ids(points, id), ", ")),
                   .message = is_end(id) ? "is an end of the flight, which is not listed"
                                         : "no correction point has this id"});
    return std::nullopt;
  }

  void throw_if_any() { alate::throw_if_any(std::move(faults_)); }

 private:
  bool is_end(int id) const { return id == navigation_.start_id || id == navigation_.goal_id; }
  void refuse(int place, Fault fault) {
    if (faults_.size() == kMaxFaults) return;
    fault.file = source_;
    fault.field = fmt::format("id {}", place);
    faults_.push_back(std::move(fault));
  }

  const Navigation& navigation_;
  std::string source_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<int> read_point_ids(const Site& site, const std::string& ids, const std::string& source) {
  if (!site.navigation) {
    throw InputError(
        Fault{.file = source, .message = "needs a scenario with navigation; " + site.scenario.file + " has none"});
  }
  if (ids.empty())
    throw InputError(
        Fault{.file = source, .value = "nothing", .limit = "ids like 503,294", .message = "lists no points"});
  const auto count = static_cast<std::size_t>(std::ranges::count(ids, ',')) + 1;
  if (count > kMaxRouteStates) {
    throw InputError(Fault{.file = source,
                           .value = fmt::format("{}", count),
                           .limit = fmt::format("<= {}", kMaxRouteStates),
                           .message = "too many points"});
  }
  ListReader reader(*site.navigation, source);
  std::vector<int> read;
  int place = 0;
  for (std::size_t begin = 0; begin <= ids.size();) {
    const std::size_t end = std::min(ids.find(',', begin), ids.size());
    if (const auto id = reader.read(std::string_view(ids).substr(begin, end - begin), ++place)) read.push_back(*id);
    begin = end + 1;
  }
  reader.throw_if_any();
  return read;
}

}  // namespace alate
