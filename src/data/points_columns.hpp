// The columns of a file of correction points.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "alate/core/fault.hpp"

namespace alate {

enum class PointColumn { id, x, y, z, lat, lon, amsl, kind, may_fail, success };

inline constexpr std::array<const char*, 10> kPointColumns{"id",  "x_m",    "y_m",  "z_m",      "lat",
                                                           "lon", "amsl_m", "kind", "may_fail", "success"};

inline const char* name_of(PointColumn column) { return kPointColumns.at(static_cast<std::size_t>(column)); }

/// Which column stands where.
struct PointColumns {
  std::vector<PointColumn> order;
  bool geographic = false;  ///< lat, lon and amsl_m in place of x_m, y_m and z_m.
};

/// A cell without the blanks and quotes around it.
std::string_view bare_cell(std::string_view cell);

/// Reads the header in line `number`. Adds a fault, without the file's name, for each column that is unknown, given
/// twice or missing.
PointColumns read_point_columns(std::string_view header, int number, std::vector<Fault>& faults);

}  // namespace alate
