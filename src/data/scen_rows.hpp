// What files of benchmark tasks have in common, whatever kind of map they are on.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/file_faults.hpp"
#include "data/text_file.hpp"
#include "data/text_words.hpp"

namespace alate {

/// Reads `version 1` and then line by line, split into columns that have names.
class ScenRows {
 public:
  /// `format` tells a person the columns. All arguments must outlive this.
  ScenRows(const std::string& file, std::vector<Fault>& faults, std::span<const char* const> names, const char* format)
      : path_(file), all_(faults), faults_(file, faults), earlier_(faults.size()), names_(names), format_(format) {}

  /// False, and a fault, unless the text begins with a version that can be read.
  bool begin(std::string_view text);
  /// The next line; false at the end of the file.
  bool next();
  /// As `next`, to a row that has all columns; others are faults.
  bool next_row();
  /// Passes over the rest, which cannot be judged.
  void give_up() { lines_.rest = {}; }
  /// True if the file had rows and there was no fault in it nor in its map. To be called once, last.
  bool finish();

  std::string_view line() const { return lines_.line; }
  std::string_view word(std::size_t column) const { return words_[column]; }
  void refuse(std::size_t column, std::string message, std::string limit);
  /// A number from 0 to `most`, or a fault.
  std::optional<double> number(std::size_t column, double most);
  std::optional<int> whole(std::size_t column, double most);

  /// Is `name` the map that the file's own name says, where it says one by `X.map.scen` or `X.3dmap.3dscen`? Other
  /// names are faults, in `column`.
  bool is_own_map(std::size_t column, std::string_view name);
  /// The file of this name in the same folder.
  std::string beside(std::string_view name) const {
    return (path_.parent_path() / std::filesystem::path(name).filename()).string();
  }
  std::vector<Fault>& all_faults() { return all_; }

 private:
  void refuse_line(Fault fault) {
    fault.line = lines_.number;
    faults_.add(std::move(fault));
  }

  std::filesystem::path path_;
  std::vector<Fault>& all_;
  FileFaults faults_;
  std::size_t earlier_;
  std::span<const char* const> names_;
  const char* format_;
  TextLines lines_;
  TextWords words_;
  std::size_t rows_ = 0;
  bool begun_ = false;
};

}  // namespace alate
