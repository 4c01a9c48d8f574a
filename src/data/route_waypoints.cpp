#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "data/mission_item.hpp"
#include "data/route_formats.hpp"
#include "data/route_lines.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

constexpr std::array<const char*, 12> kColumns{"index",  "current", "frame", "command", "param1", "param2",
                                               "param3", "param4",  "lat",   "lon",     "height", "autocontinue"};

struct Row {
  int line = 0;
  MissionItem item;
};

std::vector<std::string_view> split_at_blanks(std::string_view text) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = text.find_first_not_of(" \t"); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
    cells.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(" \t", end);
  }
  return cells;
}

std::optional<Row> row_of(const TextLine& line, RouteBuilder& builder) {
  const std::vector<std::string_view> cells = split_at_blanks(line.text);
  if (cells.size() != kColumns.size()) {
    builder.refuse({.line = line.number,
                    .value = fmt::format("{}", cells.size()),
                    .limit = fmt::format("{}", kColumns.size()),
                    .message = "wrong number of columns"});
    return std::nullopt;
  }
  std::array<std::optional<double>, kColumns.size()> values;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    values.at(i) = cell_number(cells[i], {line.number, kColumns.at(i)}, builder);
    if (!values.at(i)) return std::nullopt;
  }
  const auto frame = cell_integer(cells[2], {line.number, kColumns[2]}, builder);
  const auto command = cell_integer(cells[3], {line.number, kColumns[3]}, builder);
  if (!frame || !command) return std::nullopt;
  return Row{line.number, {*command, *frame, values[8], values[9], values[10]}};
}

bool is_header(std::string_view line) {
  const std::vector<std::string_view> words = split_at_blanks(line);
  return words.size() == 3 && words[0] == "QGC" && words[1] == "WPL" && words[2] == "110";
}

}  // namespace

void read_waypoints(const std::string& text, RouteBuilder& builder) {
  const std::vector<TextLine> lines = lines_of(text);
  if (lines.empty() || !is_header(lines.front().text)) {
    builder.refuse({.line = 1,
                    .value = lines.empty() ? "" : shortened(std::string(lines.front().text)),
                    .limit = "QGC WPL 110",
                    .message = "not a waypoint file of this version"});
    return;
  }
  std::vector<Row> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (auto row = row_of(lines[i], builder)) rows.push_back(*row);
  }
  if (rows.empty()) return;
  MissionReader reader(builder, rows.front().item.height_m);
  for (std::size_t i = 1; i < rows.size(); ++i) reader.add(rows[i].item, {.line = rows[i].line, .field = ""});
  reader.finish();
}

}  // namespace alate
