// Puts a route together from the positions of a file, whatever its format, and collects all faults on the way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/data/route_file.hpp"

namespace alate {

/// One position as a file gives it: in some metric frame, in WGS 84, or both.
struct GivenPlace {
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  std::optional<double> amsl_m;
};

/// Where in the file something stands.
struct Origin {
  int line = 0;
  std::string field;
};

class RouteBuilder {
 public:
  RouteBuilder(Frame frame, std::string file, std::string format);

  /// Adds a fault of this file; beyond kMaxFaults they are only counted.
  void refuse(Fault fault);
  void note(std::string text);

  /// Adds `state` at the given place. Where both frame and WGS 84 positions are given and differ by more than 1 m,
  /// the file was made for another frame and WGS 84 counts. Faults: out of range, no height, no place in this frame.
  void add(const GivenPlace& place, RouteState state, const Origin& origin);

  const std::string& file() const { return file_; }
  RouteFile& result() { return result_; }

  /// The route; throws InputError with all faults, also for fewer than two or too many positions.
  RouteFile finish();

  /// What is known besides the route; throws InputError with all faults.
  RouteFile finish_origin();

 private:
  std::optional<Vec2> planar_position(const GivenPlace& place, const Origin& origin);
  bool in_range(const GivenPlace& place, const Origin& origin);

  Frame frame_;
  std::string file_;
  std::size_t seen_ = 0;
  std::size_t uncounted_ = 0;
  bool other_frame_ = false;
  std::vector<Fault> faults_;
  RouteFile result_;
};

}  // namespace alate
