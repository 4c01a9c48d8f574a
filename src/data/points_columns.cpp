#include "data/points_columns.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "alate/core/param_table.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

std::optional<PointColumn> column_named(std::string_view name) {
  const auto* const found = std::ranges::find(kPointColumns, name);
  if (found == kPointColumns.end()) return std::nullopt;
  return static_cast<PointColumn>(found - kPointColumns.begin());
}

Fault unknown(std::string_view name) {
  const std::string near = nearest(name, {kPointColumns.begin(), kPointColumns.end()});
  return {.value = shortened(std::string(name)),
          .limit = near.empty() ? fmt::format("{}", fmt::join(kPointColumns, ", ")) : "",
          .message = "unknown column" + (near.empty() ? "" : "; did you mean " + near + "?")};
}

/// The place columns count as missing in the set that the header began, or that is usual.
void add_missing(PointColumns& columns, int number, std::vector<Fault>& faults) {
  using enum PointColumn;
  const auto has = [&](PointColumn column) { return std::ranges::find(columns.order, column) != columns.order.end(); };
  const bool metric = has(x) || has(y) || has(z);
  columns.geographic = has(lat) || has(lon) || has(amsl);
  if (metric && columns.geographic) {
    faults.push_back({.line = number,
                      .limit = "x_m, y_m, z_m | lat, lon, amsl_m",
                      .message = "the places need exactly one of these sets of columns"});
  }
  std::vector<PointColumn> needed{id, x, y, z, kind, may_fail};
  if (columns.geographic) needed = {id, lat, lon, amsl, kind, may_fail};
  for (const PointColumn column : needed) {
    if (!has(column)) faults.push_back({.line = number, .field = name_of(column), .message = "the column is missing"});
  }
}

}  // namespace

std::string_view bare_cell(std::string_view cell) {
  constexpr std::string_view kBlanks = " \t";
  const auto trim = [&] {
    cell.remove_prefix(std::min(cell.find_first_not_of(kBlanks), cell.size()));
    cell.remove_suffix(cell.size() - (cell.find_last_not_of(kBlanks) + 1));
  };
  trim();
  if (cell.size() < 2 || !cell.starts_with('"') || !cell.ends_with('"')) return cell;
  cell = cell.substr(1, cell.size() - 2);
  trim();
  return cell;
}

PointColumns read_point_columns(std::string_view header, int number, std::vector<Fault>& faults) {
  PointColumns columns;
  for (std::size_t begin = 0; begin <= header.size();) {
    const std::size_t end = std::min(header.find(',', begin), header.size());
    const std::string_view name = bare_cell(header.substr(begin, end - begin));
    const auto column = column_named(name);
    const auto refuse = [&](Fault fault) {
      fault.line = number;
      fault.column = static_cast<int>(begin) + 1;
      faults.push_back(std::move(fault));
    };
    if (!column) {
      refuse(unknown(name));
    } else if (std::ranges::find(columns.order, *column) != columns.order.end()) {
      refuse({.field = name_of(*column), .message = "the column is given twice"});
    } else {
      columns.order.push_back(*column);
    }
    begin = end + 1;
  }
  add_missing(columns, number, faults);
  return columns;
}

}  // namespace alate
