// Bad input: every fault of one reading is collected and reported at once.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace alate {

/// One thing wrong with what the user gave. Empty strings and zero lines mean "does not apply".
struct Fault {
  std::string file;     ///< File as the user named it, or "--override", "--set", ...
  int line = 0;         ///< 1-based; 0 where the file has no lines (rasters, options).
  int column = 0;       ///< 1-based.
  std::string field;    ///< Dotted path, e.g. `threats.0.radius_m`.
  std::string value;    ///< What was given, as written.
  std::string limit;    ///< What is allowed, e.g. `> 0`.
  std::string unit;     ///< Unit of value and limit, e.g. `m`.
  std::string message;  ///< One plain sentence without the parts above.

  bool operator==(const Fault&) const = default;
};

/// `file:line:column: field: message (got VALUE, allowed LIMIT UNIT)`, leaving out what is empty.
/// One line; control characters are shown as `\x1b`.
std::string to_string(const Fault& fault);

/// Thrown for bad input only (exit code 2); carries all faults found, at least one.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  explicit InputError(Fault fault);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// Throws InputError if `faults` is not empty.
void throw_if_any(std::vector<Fault> faults);

}  // namespace alate
