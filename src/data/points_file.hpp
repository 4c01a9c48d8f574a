// Correction points from a CSV file.
#pragma once

#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "data/given_points.hpp"

namespace alate {

/// Reads the columns id, x_m, y_m, z_m (or lat, lon, amsl_m), kind, may_fail and, if there, success; in any order,
/// lines ending in LF or CRLF, cells plain or in quotes. A point that may fail works with the chance in its own cell of
/// `success`, or with `success` if there is none. Adds every fault, with line and column, up to kMaxFaults.
GivenPoints read_points_file(const std::string& file, double success, std::vector<Fault>& faults);

}  // namespace alate
