#include "data/scen_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "core/number_text.hpp"
#include "data/file_faults.hpp"
#include "data/grid_map.hpp"
#include "data/limits.hpp"
#include "data/scenario_text.hpp"
#include "data/text_file.hpp"

namespace alate {

namespace {

namespace fs = std::filesystem;

enum Column : std::size_t { bucket, map, width, height, start_x, start_y, goal_x, goal_y, optimum };
constexpr std::size_t kColumns = optimum + 1;
constexpr std::array<const char*, kColumns> kNames{"bucket",  "map",    "width",  "height",        "start x",
                                                   "start y", "goal x", "goal y", "optimal length"};

/// Reads the rows of one file.
class Reader {
 public:
  Reader(const std::string& file, std::vector<Fault>& faults) : path_(file), all_(faults), faults_(file, faults) {}

  std::optional<ScenFile> read(std::string_view text);

 private:
  void refuse(Fault fault) {
    fault.line = lines_.number;
    faults_.add(std::move(fault));
  }
  void refuse(Column column, std::string message, std::string limit);
  void split();
  bool read_version();
  bool read_map();
  void read_row();
  bool fits_map();
  std::optional<double> number(Column column, double most);
  std::optional<int> whole(Column column, double most);
  std::optional<std::array<int, 2>> cell(Column x, Column y);

  fs::path path_;
  std::vector<Fault>& all_;
  FileFaults faults_;
  TextLines lines_;
  std::array<std::string_view, kColumns> cells_;
  std::size_t count_ = 0;  ///< Columns of the line.
  std::string map_name_;
  ScenFile scen_;
};

void Reader::refuse(Column column, std::string message, std::string limit) {
  const std::string_view text = cells_.at(column);
  refuse({.column = static_cast<int>(text.data() - lines_.line.data()) + 1,
          .field = kNames.at(column),
          .value = shortened(std::string(text)),
          .limit = std::move(limit),
          .message = std::move(message)});
}

void Reader::split() {
  constexpr std::string_view kBlanks = " \t";
  count_ = 0;
  for (std::size_t begin = lines_.line.find_first_not_of(kBlanks); begin < lines_.line.size(); ++count_) {
    const std::size_t end = std::min(lines_.line.find_first_of(kBlanks, begin), lines_.line.size());
    if (count_ < kColumns) cells_.at(count_) = lines_.line.substr(begin, end - begin);
    begin = lines_.line.find_first_not_of(kBlanks, end);
  }
}

bool Reader::read_version() {
  split();
  if (count_ == 2 && cells_[0] == "version" && (cells_[1] == "1" || cells_[1] == "1.0")) return true;
  refuse({.column = 1,
          .value = shortened(std::string(lines_.line)),
          .limit = "version 1",
          .message = "the first line must name a version that can be read"});
  return false;
}

/// The map that the first row names, beside the file.
bool Reader::read_map() {
  map_name_ = cells_[map];
  const std::string name = fs::path(map_name_).filename().string();
  const std::string own = path_.filename().string();
  if (own.ends_with(".map.scen") && own != name + ".scen")
    refuse(map, "the rows are of another map than the name of the file says", own.substr(0, own.size() - 5));
  auto grid = read_grid_map((path_.parent_path() / name).string(), all_);
  if (!grid) return false;
  scen_.grid = std::move(*grid);
  return true;
}

std::optional<double> Reader::number(Column column, double most) {
  const NumberText text = parse_number(cells_.at(column));
  if (text.problem.empty() && text.value >= 0 && text.value <= most) return text.value;
  refuse(column, text.problem.empty() ? "out of range" : text.problem, fmt::format("0 to {}", most));
  return std::nullopt;
}

std::optional<int> Reader::whole(Column column, double most) {
  const auto value = number(column, most);
  if (!value || *value == std::floor(*value)) return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
  refuse(column, "must be a whole number", fmt::format("0 to {}", most));
  return std::nullopt;
}

bool Reader::fits_map() {
  if (cells_[map] != map_name_) {
    refuse(map, "all rows must be of one map", map_name_);
    return false;
  }
  const auto columns = whole(width, kMaxGridSide);
  const auto rows = whole(height, kMaxGridSide);
  if (columns && *columns != scen_.grid.columns)
    refuse(width, "is not that of the map", fmt::format("{}", scen_.grid.columns));
  if (rows && *rows != scen_.grid.rows) refuse(height, "is not that of the map", fmt::format("{}", scen_.grid.rows));
  return columns == scen_.grid.columns && rows == scen_.grid.rows;
}

std::optional<std::array<int, 2>> Reader::cell(Column x, Column y) {
  const auto column = whole(x, scen_.grid.columns - 1);
  const auto row = whole(y, scen_.grid.rows - 1);
  if (!column || !row) return std::nullopt;
  if (!scen_.grid.blocked_at(*column, *row)) return {{*column, *row}};
  refuse(x, fmt::format("the cell [{}, {}] is blocked", *column, *row), "a free cell");
  return std::nullopt;
}

void Reader::read_row() {
  split();
  if (count_ != kColumns) {
    refuse({.value = fmt::format("{}", count_),
            .limit = fmt::format("{}", kColumns),
            .message = "wrong number of columns: bucket, map, width, height, start x and y, goal x and y, length"});
    return;
  }
  if (map_name_.empty() && !read_map()) {
    lines_.rest = {};
    return;
  }
  if (!fits_map()) return;
  whole(bucket, kMaxMagnitude);
  const auto start = cell(start_x, start_y);
  const auto goal = cell(goal_x, goal_y);
  const auto length = number(optimum, kMaxMagnitude);
  if (start && goal && length) scen_.rows.push_back({(*start)[0], (*start)[1], (*goal)[0], (*goal)[1], *length});
}

std::optional<ScenFile> Reader::read(std::string_view text) {
  const std::size_t earlier = all_.size();
  lines_.rest = text;
  std::size_t rows = 0;
  if (text.find('\0') != std::string_view::npos) {
    refuse({.message = "is not a text file"});
  } else if (!lines_.next()) {
    refuse({.message = "the file is empty"});
  } else if (read_version()) {
    while (lines_.next() && ++rows <= kMaxScenRows) read_row();
    if (rows == 0) refuse({.message = "the file has a version but no rows"});
    if (rows > kMaxScenRows) refuse({.limit = fmt::format("<= {}", kMaxScenRows), .message = "too many rows"});
  }
  faults_.finish(lines_.number);
  if (all_.size() > earlier) return std::nullopt;
  return std::move(scen_);
}

}  // namespace

double scen_tolerance(double published) {
  constexpr double kLeast = 1e-3;
  constexpr int kDigits = 6;
  if (published <= 1) return kLeast;
  return std::max(kLeast, 0.5 * std::pow(10.0, std::floor(std::log10(published)) + 1 - kDigits));
}

std::optional<ScenFile> read_scen_file(const std::string& file, std::vector<Fault>& faults) {
  try {
    return Reader(file, faults).read(read_text_file(file, kMaxScenBytes));
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

}  // namespace alate
