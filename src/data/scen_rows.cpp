#include "data/scen_rows.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/number_text.hpp"
#include "data/scenario_text.hpp"

namespace alate {

void ScenRows::refuse(std::size_t column, std::string message, std::string limit) {
  refuse_line({.column = words_.column(column),
               .field = names_[column],
               .value = shortened(std::string(words_[column])),
               .limit = std::move(limit),
               .message = std::move(message)});
}

bool ScenRows::begin(std::string_view text) {
  lines_.rest = text;
  if (text.find('\0') != std::string_view::npos) {
    refuse_line({.message = "is not a text file"});
  } else if (!next()) {
    refuse_line({.message = "the file is empty"});
  } else if (words_.count() == 2 && words_[0] == "version" && (words_[1] == "1" || words_[1] == "1.0")) {
    begun_ = true;
  } else {
    refuse_line({.column = 1,
                 .value = shortened(std::string(lines_.line)),
                 .limit = "version 1",
                 .message = "the first line must name a version that can be read"});
  }
  return begun_;
}

bool ScenRows::next() {
  if (!lines_.next()) return false;
  words_.split(lines_.line);
  return true;
}

bool ScenRows::next_row() {
  while (next()) {
    if (++rows_ > kMaxScenRows) {
      refuse_line({.limit = fmt::format("<= {}", kMaxScenRows), .message = "too many rows"});
      return false;
    }
    if (words_.count() == names_.size()) return true;
    refuse_line({.value = fmt::format("{}", words_.count()),
                 .limit = fmt::format("{}", names_.size()),
                 .message = fmt::format("wrong number of columns: {}", format_)});
  }
  return false;
}

bool ScenRows::finish() {
  if (begun_ && rows_ == 0 && all_.size() == earlier_) refuse_line({.message = "the file has a version but no rows"});
  faults_.finish(lines_.number);
  return all_.size() == earlier_;
}

std::optional<double> ScenRows::number(std::size_t column, double most) {
  const NumberText text = parse_number(words_[column]);
  if (text.problem.empty() && text.value >= 0 && text.value <= most) return text.value;
  refuse(column, text.problem.empty() ? "out of range" : text.problem, fmt::format("0 to {}", most));
  return std::nullopt;
}

std::optional<int> ScenRows::whole(std::size_t column, double most) {
  const auto value = number(column, most);
  if (!value || *value == std::floor(*value)) return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
  refuse(column, "must be a whole number", fmt::format("0 to {}", most));
  return std::nullopt;
}

bool ScenRows::is_own_map(std::size_t column, std::string_view name) {
  const std::string own = path_.stem().string();
  const std::string kind = path_.extension().string();
  const bool says = (kind == ".scen" && own.ends_with(".map")) || (kind == ".3dscen" && own.ends_with(".3dmap"));
  if (!says || own == std::filesystem::path(name).filename().string()) return true;
  refuse_line({.column = words_.column(column),
               .field = "map",
               .value = shortened(std::string(name)),
               .limit = own,
               .message = "the rows are of another map than the name of the file says"});
  return false;
}

}  // namespace alate
