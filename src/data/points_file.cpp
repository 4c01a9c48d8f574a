#include "data/points_file.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <string_view>

#include "core/number_text.hpp"
#include "data/file_faults.hpp"
#include "data/limits.hpp"
#include "data/points_columns.hpp"
#include "data/scenario_text.hpp"
#include "data/text_file.hpp"

namespace alate {

namespace {

using enum PointColumn;

/// What an ordinary cell holds; nothing where parse_number must say what is wrong.
std::optional<double> plain_number(std::string_view cell) {
  const std::string_view digits = cell.substr(cell.starts_with('-') ? 1 : 0);
  const auto is_digit = [&](std::size_t i) { return i < digits.size() && digits[i] >= '0' && digits[i] <= '9'; };
  if (!is_digit(0) || (digits[0] == '0' && is_digit(1))) return std::nullopt;
  double value = 0;
  const char* end = std::to_address(cell.end());
  const auto [stopped, error] = std::from_chars(std::to_address(cell.begin()), end, value);
  return stopped == end && error == std::errc{} ? std::optional(value) : std::nullopt;
}

/// Reads the rows of one file.
class Reader {
 public:
  Reader(const std::string& file, double success, std::vector<Fault>& faults)
      : success_(success), faults_(file, faults) {}

  GivenPoints read(std::string_view text);

 private:
  struct Limits {
    double min;
    double max;
  };

  void refuse(Fault fault) { faults_.add(std::move(fault)); }
  void refuse(PointColumn column, const char* message, std::string limit = "");
  bool read_header(std::string_view line);
  /// Finds the cells; false, with a fault, if there are not as many as columns.
  bool split(std::string_view line);
  void read_row(std::string_view line);
  std::optional<double> number(PointColumn column, Limits limits);
  std::optional<int> id_of();
  std::optional<PointKind> kind_of();
  std::optional<Vec3> place();
  std::optional<double> chance();

  std::string_view& cell(PointColumn column) { return cells_.at(static_cast<std::size_t>(column)); }

  double success_;
  FileFaults faults_;
  int number_ = 0;  ///< Of the line.
  std::string_view line_;
  PointColumns columns_;
  std::array<std::string_view, kPointColumns.size()> cells_;
  GivenPoints points_;
};

void Reader::refuse(PointColumn column, const char* message, std::string limit) {
  const std::string_view text = cell(column);
  refuse({.line = number_,
          .column = text.empty() ? 0 : static_cast<int>(text.data() - line_.data()) + 1,
          .field = name_of(column),
          .value = text.empty() ? "nothing" : shortened(std::string(text)),
          .limit = std::move(limit),
          .message = message});
}

bool Reader::read_header(std::string_view line) {
  std::vector<Fault> found;
  columns_ = read_point_columns(line, number_, found);
  for (Fault& fault : found) refuse(std::move(fault));
  return found.empty();
}

bool Reader::split(std::string_view line) {
  line_ = line;
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= line.size(); ++count) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    if (count < columns_.order.size()) cell(columns_.order[count]) = bare_cell(line.substr(begin, end - begin));
    begin = end + 1;
  }
  if (count == columns_.order.size()) return true;
  refuse({.line = number_,
          .value = fmt::format("{}", count),
          .limit = fmt::format("{}", columns_.order.size()),
          .message = "wrong number of columns"});
  return false;
}

std::optional<double> Reader::number(PointColumn column, Limits limits) {
  const auto limit = [&] { return fmt::format("{} to {}", limits.min, limits.max); };
  auto value = plain_number(cell(column));
  if (!value) {
    const NumberText text = parse_number(cell(column));
    if (!text.problem.empty()) {
      refuse(column, text.problem.c_str(), limit());
      return std::nullopt;
    }
    value = text.value;
  }
  if (*value >= limits.min && *value <= limits.max) return value;
  refuse(column, "out of range", limit());
  return std::nullopt;
}

std::optional<int> Reader::id_of() {
  const auto value = number(id, {0, kMaxPointId});
  if (!value) return std::nullopt;
  if (*value == std::floor(*value)) return static_cast<int>(*value);
  refuse(id, "must be a whole number");
  return std::nullopt;
}

std::optional<PointKind> Reader::kind_of() {
  const std::string_view word = cell(kind);
  if (word == "vertical") return PointKind::vertical;
  if (word == "horizontal") return PointKind::horizontal;
  if (word == "start") return PointKind::start;
  if (word == "end") return PointKind::end;
  refuse(kind, "unknown word", "start | end | vertical | horizontal");
  return std::nullopt;
}

std::optional<Vec3> Reader::place() {
  constexpr Limits kMetres{-kMaxMagnitude, kMaxMagnitude};
  const bool on_earth = columns_.geographic;
  const auto first = on_earth ? number(lat, {-90, 90}) : number(x, kMetres);
  const auto second = on_earth ? number(lon, {-180, 180}) : number(y, kMetres);
  const auto height = number(on_earth ? amsl : z, kMetres);
  if (!first || !second || !height) return std::nullopt;
  return Vec3(*first, *second, *height);
}

std::optional<double> Reader::chance() {
  const std::string_view flag = cell(may_fail);
  const bool fails = flag == "1";
  if (!fails && flag != "0") {
    refuse(may_fail, "must be 0 or 1", "0 | 1");
    return std::nullopt;
  }
  if (cell(success).empty()) return fails ? success_ : 1;
  const auto own = number(success, {0, 1});
  if (!own || fails || *own == 1) return own;
  refuse(success, "must be 1 or nothing where may_fail is 0", "1");
  return std::nullopt;
}

void Reader::read_row(std::string_view line) {
  if (!split(line)) return;
  const auto own_id = id_of();
  const auto where = place();
  const auto what = kind_of();
  const auto works = chance();
  const auto twice = own_id ? points_.claim_id(*own_id) : std::nullopt;
  const auto second_end = what ? points_.claim_kind(*what, own_id) : std::nullopt;
  if (twice) refuse(id, twice->message.c_str(), twice->limit);
  if (second_end) refuse(kind, second_end->message.c_str(), second_end->limit);
  if (!own_id || !where || !what || !works || twice || second_end) return;
  points_.take({.point = {.id = *own_id, .position = *where, .kind = *what, .success = *works},
                .geographic = columns_.geographic,
                .row = number_});
}

GivenPoints Reader::read(std::string_view text) {
  bool header = false;
  std::size_t rows = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (!header) {
      header = read_header(line);
      if (!header) return {};
    } else if (++rows <= kMaxPoints) {
      read_row(line);
    } else {
      refuse({.line = number_, .limit = fmt::format("<= {}", kMaxPoints), .message = "too many points"});
      break;
    }
  }
  if (!header) refuse({.message = "the file is empty"});
  if (header && rows == 0) refuse({.message = "the file has a header but no points"});
  if (const auto fault = points_.missing_end(); fault)
    refuse({.field = "kind", .limit = fault->limit, .message = fault->message});
  faults_.finish();
  return std::move(points_);
}

}  // namespace

GivenPoints read_points_file(const std::string& file, double success, std::vector<Fault>& faults) {
  const std::string text = read_text_file(file, kMaxPointsBytes);
  if (text.find('\0') == std::string::npos) return Reader(file, success, faults).read(text);
  faults.push_back({.file = file, .message = "is not a text file"});
  return {};
}

}  // namespace alate
