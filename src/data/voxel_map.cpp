#include "data/voxel_map.hpp"

#include <fmt/core.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

#include "data/file_faults.hpp"
#include "data/limits.hpp"
#include "data/scenario_text.hpp"
#include "data/text_file.hpp"
#include "data/text_words.hpp"

namespace alate {

namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
constexpr std::string_view kHeader = "voxel";

/// Reads the lines of one file.
class Reader {
 public:
  Reader(const std::string& file, std::vector<Fault>& faults) : faults_(file, faults) {}

  std::optional<VoxelGrid> read(std::string_view text);

 private:
  void refuse(Fault fault) {
    fault.line = lines_.number;
    faults_.add(std::move(fault));
  }
  bool has_words(std::size_t count, const char* format);
  std::optional<int> whole(std::size_t word, std::size_t axis, std::array<int, 2> range);
  /// Three numbers from word `first` on, each from `least` to its `most`.
  std::optional<VoxelCell> three(std::size_t first, int least, const VoxelCell& most);
  std::optional<VoxelGrid> read_header();

  FileFaults faults_;
  TextLines lines_;
  TextWords words_;
};

bool Reader::has_words(std::size_t count, const char* format) {
  if (words_.count() == count) return true;
  refuse({.column = 1,
          .value = shortened(std::string(lines_.line)),
          .limit = format,
          .message = words_.count() < count ? "too few numbers" : "words that do not belong here"});
  return false;
}

std::optional<int> Reader::whole(std::size_t word, std::size_t axis, std::array<int, 2> range) {
  const std::string_view text = words_[word];
  int value = 0;
  const char* end = std::to_address(text.end());
  const auto [stopped, error] = std::from_chars(std::to_address(text.begin()), end, value);
  const bool is_whole = stopped == end && error != std::errc::invalid_argument;
  if (is_whole && error == std::errc{} && value >= range[0] && value <= range[1]) return value;
  refuse({.column = words_.column(word),
          .field = kAxes.at(axis),
          .value = shortened(std::string(text)),
          .limit = fmt::format("{} to {}", range[0], range[1]),
          .unit = "cells",
          .message = is_whole ? "out of range" : "must be a whole number"});
  return std::nullopt;
}

std::optional<VoxelCell> Reader::three(std::size_t first, int least, const VoxelCell& most) {
  VoxelCell cell{};
  bool sound = true;
  for (std::size_t axis = 0; axis < cell.size(); ++axis) {
    const auto value = whole(first + axis, axis, {least, most.at(axis)});
    cell.at(axis) = value.value_or(0);
    sound = sound && value;
  }
  return sound ? std::optional(cell) : std::nullopt;
}

std::optional<VoxelGrid> Reader::read_header() {
  constexpr const char* kFormat = "voxel X Y Z";
  words_.split(lines_.line);
  if (words_[0] != kHeader) {
    refuse({.column = 1,
            .value = shortened(std::string(lines_.line)),
            .limit = kFormat,
            .message = "the first line must be the header of a voxel map"});
    return std::nullopt;
  }
  if (!has_words(4, kFormat)) return std::nullopt;
  const auto size = three(1, 1, {kMaxVoxelSide, kMaxVoxelSide, kMaxVoxelSide});
  if (!size) return std::nullopt;
  const std::int64_t cells = std::int64_t{(*size)[0]} * (*size)[1] * (*size)[2];
  if (cells <= kMaxVoxels) return VoxelGrid(*size);
  refuse({.value = fmt::format("{}", cells),
          .limit = fmt::format("<= {}", kMaxVoxels),
          .unit = "cells",
          .message = "too many cells"});
  return std::nullopt;
}

std::optional<VoxelGrid> Reader::read(std::string_view text) {
  lines_.rest = text;
  std::optional<VoxelGrid> grid;
  if (auto binary = binary_fault(text)) {
    faults_.add(std::move(*binary));
  } else if (!lines_.next()) {
    refuse({.message = "the file is empty"});
  } else {
    grid = read_header();
  }
  while (grid && lines_.next()) {
    words_.split(lines_.line);
    if (!has_words(3, "x y z")) continue;
    const auto& [x, y, z] = grid->size();
    if (const auto cell = three(0, 0, {x - 1, y - 1, z - 1})) grid->block(*cell);
  }
  if (!faults_.finish(lines_.number)) return std::nullopt;
  return grid;
}

}  // namespace

bool is_voxel_map(const std::string& file) {
  if (std::filesystem::path(file).extension() == ".3dmap") return true;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::ifstream stream(file, std::ios::binary);
  std::string begin(kHeader.size() + 1, '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return stream && begin.starts_with(kHeader) && (begin.back() == ' ' || begin.back() == '\t');
}

std::optional<VoxelGrid> read_voxel_map(const std::string& file, std::vector<Fault>& faults) {
  try {
    return Reader(file, faults).read(read_text_file(file, kMaxVoxelBytes));
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

}  // namespace alate
