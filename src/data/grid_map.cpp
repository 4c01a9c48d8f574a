#include "data/grid_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>

#include "data/file_faults.hpp"
#include "data/limits.hpp"
#include "data/scenario_text.hpp"
#include "data/text_file.hpp"

namespace alate {

namespace {

constexpr std::string_view kLetters = ".GS@OTW";
constexpr std::size_t kFree = 3;  ///< So many of them are free.

/// Reads the lines of one file.
class Reader {
 public:
  Reader(const std::string& file, std::vector<Fault>& faults) : faults_(file, faults) {}

  std::optional<HeightGrid> read(std::string_view text);

 private:
  void refuse(Fault fault) { faults_.add(std::move(fault)); }
  void read_header();
  void read_key(std::string_view key, std::string_view value);
  void read_side(std::string_view key, std::string_view value, int& side);
  void read_rows();
  void read_row();
  void judge_size();

  FileFaults faults_;
  TextLines lines_;
  int rows_ = 0;  ///< Read so far.
  bool headed_ = false;
  bool sized_ = true;
  HeightGrid grid_;
};

void Reader::read_side(std::string_view key, std::string_view value, int& side) {
  const char* end = std::to_address(value.end());
  const auto [stopped, error] = std::from_chars(std::to_address(value.begin()), end, side);
  if (stopped == end && error == std::errc{} && side >= 1 && side <= kMaxGridSide) return;
  sized_ = false;
  refuse({.line = lines_.number,
          .column = static_cast<int>(key.size()) + 2,
          .field = std::string(key),
          .value = shortened(std::string(value)),
          .limit = fmt::format("1 to {}", kMaxGridSide),
          .unit = "cells",
          .message = "must be a whole number in range"});
}

void Reader::read_key(std::string_view key, std::string_view value) {
  if (key == "height") return read_side(key, value, grid_.rows);
  if (key == "width") return read_side(key, value, grid_.columns);
  if (key == "type" && value == "octile") return;
  refuse({.line = lines_.number,
          .column = 1,
          .value = shortened(std::string(lines_.line)),
          .limit = "type octile | height N | width N | map",
          .message = "unknown line of the header"});
}

void Reader::read_header() {
  const auto is_row = [&] { return lines_.line.find_first_not_of(kLetters) == std::string_view::npos; };
  bool more = lines_.next();
  for (; more && lines_.line != "map" && !is_row(); more = lines_.next()) {
    const std::size_t blank = lines_.line.find(' ');
    read_key(lines_.line.substr(0, blank), blank == std::string_view::npos ? "" : lines_.line.substr(blank + 1));
  }
  headed_ = more && lines_.line == "map";
  if (!headed_) refuse({.line = lines_.number, .limit = "map", .message = "the last line of the header is missing"});
}

void Reader::judge_size() {
  for (const auto& [key, side] : {std::pair{"height", grid_.rows}, std::pair{"width", grid_.columns}}) {
    if (side == 0 && sized_) refuse({.line = 1, .field = key, .message = "is missing in the header"});
  }
  const std::int64_t cells = std::int64_t{grid_.rows} * grid_.columns;
  sized_ = sized_ && cells > 0 && cells <= kMaxGridCells;
  if (cells <= kMaxGridCells) return;
  refuse({.line = 1,
          .value = fmt::format("{}", cells),
          .limit = fmt::format("<= {}", kMaxGridCells),
          .unit = "cells",
          .message = "too many cells"});
}

void Reader::read_row() {
  if (lines_.line.size() != static_cast<std::size_t>(grid_.columns)) {
    refuse({.line = lines_.number,
            .column = static_cast<int>(std::min(lines_.line.size(), static_cast<std::size_t>(grid_.columns))) + 1,
            .value = fmt::format("{}", lines_.line.size()),
            .limit = fmt::format("{}", grid_.columns),
            .unit = "cells",
            .message = "the row is not as long as `width` says"});
  }
  for (std::size_t i = 0; i < lines_.line.size(); ++i) {
    const std::size_t letter = kLetters.find(lines_.line[i]);
    grid_.blocked.push_back(letter < kFree ? 0 : 1);
    if (letter != std::string_view::npos) continue;
    refuse({.line = lines_.number,
            .column = static_cast<int>(i) + 1,
            .value = std::string(1, lines_.line[i]),
            .limit = ". G S (free) | @ O T W (blocked)",
            .message = "unknown cell"});
  }
}

void Reader::read_rows() {
  while (lines_.next()) {
    if (++rows_ <= grid_.rows) read_row();
  }
  if (rows_ == grid_.rows) return;
  refuse({.line = lines_.number,
          .value = fmt::format("{}", rows_),
          .limit = fmt::format("{}", grid_.rows),
          .unit = "rows",
          .message = "there are not as many rows as `height` says"});
}

std::optional<HeightGrid> Reader::read(std::string_view text) {
  lines_.rest = text;
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    refuse({.message = "the file is empty"});
  } else if (auto binary = binary_fault(text)) {
    refuse(std::move(*binary));
  } else {
    read_header();
    judge_size();
    if (headed_ && sized_) read_rows();
  }
  if (!faults_.finish(lines_.number)) return std::nullopt;
  return std::move(grid_);
}

}  // namespace

std::optional<HeightGrid> read_grid_map(const std::string& file, std::vector<Fault>& faults) {
  try {
    return Reader(file, faults).read(read_text_file(file, kMaxGridBytes));
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

}  // namespace alate
