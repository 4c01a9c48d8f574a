#include "space/dubins/dubins_batch.hpp"

#include <cassert>

#include "space/dubins/dubins_words.hpp"

namespace alate {

namespace {

using dubins::View;

ALATE_SIMD void lengths_to(const PoseColumns& from, const View& goal, double radius_m, AlignedDoubles& lengths_m) {
  const auto body = [to = goal, radius_m, per_radius = 1 / radius_m](double& length, double x, double y, double heading,
                                                                     double cos,
                                                                     double sin) __attribute__((always_inline)) {
    length = radius_m * dubins::shortest_length(dubins::goal_from({x, y, heading, cos, sin}, to, per_radius));
  };
  for_each_lane(body, lengths_m, from.x, from.y, from.heading, from.cos, from.sin);
}

ALATE_SIMD void lengths_from(const View& start, const PoseColumns& to, double radius_m, AlignedDoubles& lengths_m) {
  const auto body = [from = start, radius_m, per_radius = 1 / radius_m](double& length, double x, double y,
                                                                        double heading, double cos,
                                                                        double sin) __attribute__((always_inline)) {
    length = radius_m * dubins::shortest_length(dubins::goal_from(from, {x, y, heading, cos, sin}, per_radius));
  };
  for_each_lane(body, lengths_m, to.x, to.y, to.heading, to.cos, to.sin);
}

ALATE_SIMD void lengths_between(const PoseColumns& from, const PoseColumns& to, double radius_m,
                                AlignedDoubles& lengths_m) {
  const auto body = [radius_m, per_radius = 1 / radius_m](
                        double& length, double x, double y, double heading, double cos, double sin, double to_x,
                        double to_y, double to_heading, double to_cos, double to_sin) __attribute__((always_inline)) {
    length = radius_m * dubins::shortest_length(dubins::goal_from(
                            {x, y, heading, cos, sin}, {to_x, to_y, to_heading, to_cos, to_sin}, per_radius));
  };
  for_each_lane(body, lengths_m, from.x, from.y, from.heading, from.cos, from.sin, to.x, to.y, to.heading, to.cos,
                to.sin);
}

}  // namespace

void PoseColumns::reserve(std::size_t count) {
  for (AlignedDoubles* column : {&x, &y, &heading, &cos, &sin}) column->reserve(count);
}

void PoseColumns::clear() {
  for (AlignedDoubles* column : {&x, &y, &heading, &cos, &sin}) column->clear();
}

void PoseColumns::push_back(const PlanarPose& pose) {
  x.push_back(pose.x);
  y.push_back(pose.y);
  heading.push_back(pose.heading);
  cos.push_back(pose.cos);
  sin.push_back(pose.sin);
}

void dubins_lengths(const PoseColumns& from, const PlanarPose& to, double radius_m, AlignedDoubles& lengths_m) {
  lengths_m.resize(from.size());
  lengths_to(from, dubins::view(to), radius_m, lengths_m);
}

void dubins_lengths(const PlanarPose& from, const PoseColumns& to, double radius_m, AlignedDoubles& lengths_m) {
  lengths_m.resize(to.size());
  lengths_from(dubins::view(from), to, radius_m, lengths_m);
}

void dubins_lengths(const PoseColumns& from, const PoseColumns& to, double radius_m, AlignedDoubles& lengths_m) {
  assert(from.size() == to.size());
  lengths_m.resize(from.size());
  lengths_between(from, to, radius_m, lengths_m);
}

}  // namespace alate
