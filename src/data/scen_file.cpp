#include "data/scen_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "data/grid_map.hpp"
#include "data/limits.hpp"
#include "data/scen_rows.hpp"
#include "data/voxel_map.hpp"

namespace alate {

namespace {

enum Column : std::size_t { bucket, map, width, height, start_x, start_y, goal_x, goal_y, optimum };
constexpr std::array<const char*, optimum + 1> kNames{"bucket",  "map",    "width",  "height",        "start x",
                                                      "start y", "goal x", "goal y", "optimal length"};

/// Reads the rows of a file of tasks on a height grid.
class FlatReader {
 public:
  FlatReader(const std::string& file, std::vector<Fault>& faults)
      : rows_(file, faults, kNames, "bucket, map, width, height, start x and y, goal x and y, length") {}

  std::optional<ScenFile> read(std::string_view text) {
    if (rows_.begin(text)) {
      while (rows_.next_row()) read_row();
    }
    return rows_.finish() ? std::optional(std::move(scen_)) : std::nullopt;
  }

 private:
  bool read_map();
  void read_row();
  bool fits_map();
  std::optional<std::array<int, 2>> cell(Column x, Column y);

  ScenRows rows_;
  std::string map_name_;
  ScenFile scen_;
};

/// The map that the first row names, beside the file.
bool FlatReader::read_map() {
  map_name_ = rows_.word(map);
  rows_.is_own_map(map, map_name_);
  auto grid = read_grid_map(rows_.beside(map_name_), rows_.all_faults());
  if (!grid) return false;
  scen_.grid = std::move(*grid);
  return true;
}

bool FlatReader::fits_map() {
  if (rows_.word(map) != map_name_) {
    rows_.refuse(map, "all rows must be of one map", map_name_);
    return false;
  }
  const auto columns = rows_.whole(width, kMaxGridSide);
  const auto rows = rows_.whole(height, kMaxGridSide);
  if (columns && *columns != scen_.grid.columns)
    rows_.refuse(width, "is not that of the map", fmt::format("{}", scen_.grid.columns));
  if (rows && *rows != scen_.grid.rows)
    rows_.refuse(height, "is not that of the map", fmt::format("{}", scen_.grid.rows));
  return columns == scen_.grid.columns && rows == scen_.grid.rows;
}

std::optional<std::array<int, 2>> FlatReader::cell(Column x, Column y) {
  const auto column = rows_.whole(x, scen_.grid.columns - 1);
  const auto row = rows_.whole(y, scen_.grid.rows - 1);
  if (!column || !row) return std::nullopt;
  if (!scen_.grid.blocked_at(*column, *row)) return {{*column, *row}};
  rows_.refuse(x, fmt::format("the cell [{}, {}] is blocked", *column, *row), "a free cell");
  return std::nullopt;
}

void FlatReader::read_row() {
  if (map_name_.empty() && !read_map()) return rows_.give_up();
  if (!fits_map()) return;
  rows_.whole(bucket, kMaxMagnitude);
  const auto start = cell(start_x, start_y);
  const auto goal = cell(goal_x, goal_y);
  const auto length = rows_.number(optimum, kMaxMagnitude);
  if (start && goal && length) scen_.rows.push_back({(*start)[0], (*start)[1], (*goal)[0], (*goal)[1], *length});
}

enum VoxelColumn : std::size_t { start = 0, goal = 3, length = 6, ratio = 7 };
constexpr std::array<const char*, ratio + 1> kVoxelNames{"start x", "start y", "start z",        "goal x",
                                                         "goal y",  "goal z",  "optimal length", "ratio"};

/// Reads the rows of a file of tasks among voxels.
class VoxelReader {
 public:
  VoxelReader(const std::string& file, std::vector<Fault>& faults)
      : rows_(file, faults, kVoxelNames, "start x, y and z, goal x, y and z, length, ratio") {}

  std::optional<VoxelScenFile> read(std::string_view text) {
    if (rows_.begin(text) && rows_.next() && read_map()) {
      while (rows_.next_row()) read_row();
    }
    return rows_.finish() ? std::optional(std::move(scen_)) : std::nullopt;
  }

 private:
  bool read_map();
  void read_row();
  std::optional<VoxelCell> cell(VoxelColumn x);

  ScenRows rows_;
  VoxelScenFile scen_;
};

/// The map that the second line names, beside the file.
bool VoxelReader::read_map() {
  const std::string name(rows_.line());
  rows_.is_own_map(0, name);
  auto voxels = read_voxel_map(rows_.beside(name), rows_.all_faults());
  if (!voxels) return false;
  scen_.voxels = std::move(*voxels);
  return true;
}

std::optional<VoxelCell> VoxelReader::cell(VoxelColumn x) {
  VoxelCell cell{};
  bool sound = true;
  for (std::size_t axis = 0; axis < cell.size(); ++axis) {
    const auto value = rows_.whole(x + axis, scen_.voxels.size().at(axis) - 1);
    cell.at(axis) = value.value_or(0);
    sound = sound && value;
  }
  if (!sound) return std::nullopt;
  if (scen_.voxels.is_free(cell)) return cell;
  rows_.refuse(x, fmt::format("the cell [{}, {}, {}] is blocked", cell[0], cell[1], cell[2]), "a free cell");
  return std::nullopt;
}

void VoxelReader::read_row() {
  const auto from = cell(start);
  const auto to = cell(goal);
  const auto optimum = rows_.number(length, kMaxMagnitude);
  const auto share = rows_.number(ratio, kMaxMagnitude);
  if (from && to && optimum && share) scen_.rows.push_back({*from, *to, *optimum});
}

/// Reads the text of `file`, whose own faults join those of its lines.
template <class Reader>
auto read_file(const std::string& file, std::vector<Fault>& faults) -> decltype(Reader(file, faults).read("")) {
  try {
    return Reader(file, faults).read(read_text_file(file, kMaxScenBytes));
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

}  // namespace

double scen_tolerance(double published) {
  constexpr double kLeast = 1e-3;
  constexpr int kDigits = 6;
  if (published <= 1) return kLeast;
  return std::max(kLeast, 0.5 * std::pow(10.0, std::floor(std::log10(published)) + 1 - kDigits));
}

std::optional<ScenFile> read_scen_file(const std::string& file, std::vector<Fault>& faults) {
  return read_file<FlatReader>(file, faults);
}

std::optional<VoxelScenFile> read_voxel_scen_file(const std::string& file, std::vector<Fault>& faults) {
  return read_file<VoxelReader>(file, faults);
}

}  // namespace alate
