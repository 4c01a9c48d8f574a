// Konatowski, Pawlowski 2019 word for word, as a baseline: three Rodrigues rotations a candidate, pow, and trails in a
// map of exact points. Slow on purpose.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "alate/core/stream.hpp"
#include "alate/data/site.hpp"

namespace alate::bench {

struct Point {
  double x, y, z;
  bool operator==(const Point&) const = default;
};
struct PointHash {
  std::size_t operator()(const Point& p) const {
    const std::hash<double> hash;
    return hash(p.x) * 31 * 31 + hash(p.y) * 31 + hash(p.z);
  }
};
using PointTrails = std::unordered_map<Point, double, PointHash>;

/// Eq. (15): rotation by `angle` about the unit vector `w`.
inline Mat3 rodrigues(const Vec3& w, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double v = 1 - c;
  Mat3 r;
  r << c + w.x() * w.x() * v, w.x() * w.y() * v - w.z() * s, w.x() * w.z() * v + w.y() * s,
      w.y() * w.x() * v + w.z() * s, c + w.y() * w.y() * v, w.y() * w.z() * v - w.x() * s,
      w.z() * w.x() * v - w.y() * s, w.z() * w.y() * v + w.x() * s, c + w.z() * w.z() * v;
  return r;
}

class LiteralAnt {
 public:
  LiteralAnt(const Site& site, const PointTrails& trails) : site_(site), trails_(trails) {}

  /// Walks from the start until the goal or `most` steps; the number of steps.
  std::size_t walk(Stream stream, std::size_t most) {
    position_ = site_.mission.start;
    attitude_ = Mat3::Identity();
    for (std::size_t step = 1; step <= most; ++step) {
      move(stream);
      if ((position_ - site_.mission.goal).norm() <= site_.mission.tolerance_m) return step;
    }
    return most;
  }

 private:
  struct Candidate {
    Mat3 attitude;
    Vec3 position;
    double weight = 0;
  };

  void move(Stream& stream) {
    candidates_.clear();
    double sum = 0;
    for (const double roll : site_.vehicle.roll_rad) {
      for (const double pitch : site_.vehicle.pitch_rad) {
        for (const double yaw : site_.vehicle.yaw_rad) {
          candidates_.push_back(candidate(roll, pitch, yaw));
          sum += candidates_.back().weight;
        }
      }
    }
    double left = stream.uniform() * sum;
    std::size_t k = 0;
    while (k + 1 < candidates_.size() && left >= candidates_[k].weight) left -= candidates_[k++].weight;
    position_ = candidates_[k].position;
    attitude_ = candidates_[k].attitude;
  }

  /// Eqs. (16)-(25), then the numerator of eq. (1).
  Candidate candidate(double roll, double pitch, double yaw) const {
    const Mat3 first = rodrigues(attitude_.col(0), roll) * attitude_;
    const Mat3 second = rodrigues(first.col(1), pitch) * first;
    Candidate result{.attitude = rodrigues(second.col(2), yaw) * second};
    result.position = position_ + *site_.vehicle.step_m * result.attitude.col(0);
    const auto known = trails_.find({result.position.x(), result.position.y(), result.position.z()});
    const double tau = known == trails_.end() ? 1.0 : known->second;
    result.weight = std::pow(tau, 1.0) * std::pow(1 / cost(result.position), 3.0);
    return result;
  }

  /// Eqs. (33), (34).
  double cost(const Vec3& node) const {
    const ObjectiveSpec& weights = site_.scenario.objective;
    double threat = 0;
    for (const Threat& one : site_.threats)
      threat += one.level * std::max(0.0, one.radius_m - (node - one.center).norm());
    return weights.fuel * (node - site_.mission.goal).norm() + weights.threat * threat;
  }

  const Site& site_;
  const PointTrails& trails_;
  Vec3 position_;
  Mat3 attitude_;
  std::vector<Candidate> candidates_;
};

}  // namespace alate::bench
