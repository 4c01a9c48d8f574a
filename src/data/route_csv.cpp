#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "data/route_formats.hpp"
#include "data/route_lines.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

/// Cells between commas, without blanks around them.
std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view cell = text.substr(begin, end - begin);
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
    cells.push_back(cell);
    begin = end + 1;
  }
  return cells;
}

using Columns = std::map<std::string, std::size_t, std::less<>>;

/// One line, its cells found by the header's names.
class Record {
 public:
  Record(const TextLine& line, const Columns& columns, RouteBuilder& builder)
      : line_(line.number), cells_(split_at_commas(line.text)), columns_(columns), builder_(builder) {}

  std::size_t size() const { return cells_.size(); }
  std::string_view text(const std::string& name) const {
    const auto found = columns_.find(name);
    return found == columns_.end() ? std::string_view() : cells_.at(found->second);
  }
  std::optional<double> number(const std::string& name) const {
    return cell_number(text(name), {line_, name}, builder_);
  }
  std::optional<int> integer(const std::string& name) const {
    return cell_integer(text(name), {line_, name}, builder_);
  }

 private:
  int line_;
  std::vector<std::string_view> cells_;
  const Columns& columns_;
  RouteBuilder& builder_;
};

LegKind kind_of(const Record& record, int line, RouteBuilder& builder) {
  const std::string_view name = record.text("kind");
  for (const LegKind kind : {LegKind::start, LegKind::straight, LegKind::arc, LegKind::climb}) {
    if (name == to_string(kind)) return kind;
  }
  if (!name.empty()) {
    builder.refuse({.line = line,
                    .field = "kind",
                    .value = shortened(std::string(name)),
                    .limit = "start, straight, arc or climb",
                    .message = "unknown kind of leg"});
  }
  return LegKind::straight;
}

Columns columns_of(const TextLine& header, RouteBuilder& builder) {
  Columns columns;
  for (const std::string_view name : split_at_commas(header.text)) {
    if (!columns.emplace(name, columns.size()).second) {
      builder.refuse({.line = header.number, .value = shortened(std::string(name)), .message = "column given twice"});
    }
  }
  const auto has = [&](const char* name) { return columns.contains(name); };
  const bool placed = (has("x_m") && has("y_m")) || (has("lat") && has("lon"));
  if (!placed || !(has("z_m") || has("amsl_m"))) {
    builder.refuse({.line = header.number,
                    .limit = "x_m, y_m, z_m or lat, lon, amsl_m",
                    .message = "the header lacks the columns of a position"});
  }
  return columns;
}

/// Adds the state of one line. A leg of kind arc is taken as straight; the answer says so.
bool add_record(const Record& record, int line, RouteBuilder& builder) {
  RouteState state{.position = Vec3::Zero(), .leg = kind_of(record, line, builder)};
  state.point_id = record.integer("point_id");
  const bool arc = state.leg == LegKind::arc;
  if (arc) state.leg = LegKind::straight;
  const auto z = record.number("z_m");
  builder.add({.x_m = record.number("x_m"),
               .y_m = record.number("y_m"),
               .lat_deg = record.number("lat"),
               .lon_deg = record.number("lon"),
               .amsl_m = z ? z : record.number("amsl_m")},
              state, {.line = line, .field = ""});
  return arc;
}

}  // namespace

void read_csv(const std::string& text, RouteBuilder& builder) {
  const std::vector<TextLine> lines = lines_of(text);
  if (lines.empty()) return;
  const Columns columns = columns_of(lines.front(), builder);
  bool arcs = false;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Record record(lines[i], columns, builder);
    if (record.size() == columns.size()) {
      arcs = add_record(record, lines[i].number, builder) || arcs;
      continue;
    }
    builder.refuse({.line = lines[i].number,
                    .value = fmt::format("{}", record.size()),
                    .limit = fmt::format("{}", columns.size()),
                    .message = "wrong number of columns"});
  }
  if (arcs) builder.note("arcs are judged as straight lines: a CSV file holds no circles");
}

}  // namespace alate
