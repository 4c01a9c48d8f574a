#include "flight_space.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/samplers/InformedStateSampler.h>

#include <algorithm>
#include <cmath>

namespace alate::peers {

namespace {

constexpr int kTries = 20;  ///< To find a place where the band is open, or a heading to arrive by.

/// A place from which a way of `length_m` between the foci can pass: uniform in an ellipse.
Vec2 in_ellipse(ompl::RNG& random, const Vec2& a, const Vec2& b, double length_m) {
  const double half = std::max(length_m, (b - a).norm()) / 2;
  const double focal = (b - a).norm() / 2;
  const double minor = std::sqrt(std::max(0.0, half * half - focal * focal));
  const double radius = std::sqrt(random.uniform01());
  const double angle = random.uniformReal(0, 2 * kPi);
  const Vec2 along = focal > 0 ? Vec2((b - a) / (2 * focal)) : Vec2(1, 0);
  const Vec2 across(-along.y(), along.x());
  return (a + b) / 2 + half * radius * std::cos(angle) * along + minor * radius * std::sin(angle) * across;
}

/// Any heading, an altitude inside the band. False if the band stayed closed.
bool draw_state(ompl::RNG& random, const FlightLegs& legs, double most_length_m, Waypoint& drawn) {
  const Box2& area = legs.area();
  const Vec2 start = legs.mission().start.head<2>();
  for (int i = 0; i < kTries; ++i) {
    const Vec2 place =
        std::isfinite(most_length_m)
            ? in_ellipse(random, start, legs.end().place(), most_length_m + legs.end().tolerance_m)
            : Vec2(random.uniformReal(area.min.x(), area.max.x()), random.uniformReal(area.min.y(), area.max.y()));
    drawn.pose = planar_pose(place.x(), place.y(), random.uniformReal(-kPi, kPi));
    const auto altitudes = legs.altitudes(drawn.pose);
    if (!altitudes) continue;
    drawn.z = random.uniformReal(altitudes->first, altitudes->second);
    return true;
  }
  return false;
}

class FlightSampler : public ob::StateSampler {
 public:
  explicit FlightSampler(const FlightSpace& space) : ob::StateSampler(&space), flights_(space) {}

  void sampleUniform(ob::State* state) override {
    draw_state(rng_, flights_.legs(), flights_.most_length(), at(state));
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    draw_near(state, at(near), [&] { return rng_.uniformReal(-distance, distance); });
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    draw_near(state, at(mean), [&] { return rng_.gaussian(0, deviation); });
  }

 private:
  template <class Draw>
  void draw_near(ob::State* state, const Waypoint& near, const Draw& draw) {
    const double x = near.pose.x + draw();
    const double y = near.pose.y + draw();
    at(state) = {.pose = planar_pose(x, y, near.pose.heading + draw() / flights_.legs().radius_m()),
                 .z = near.z + draw() / 10};
    flights_.enforceBounds(state);
  }

  const FlightSpace& flights_;
};

class FlightValidity : public ob::StateValidityChecker {
 public:
  FlightValidity(const ob::SpaceInformationPtr& information, const FlightLegs& legs)
      : ob::StateValidityChecker(information), legs_(legs) {}
  bool isValid(const ob::State* state) const override {
    const auto altitudes = legs_.altitudes(at(state).pose);
    return altitudes && altitudes->first <= at(state).z && at(state).z <= altitudes->second;
  }

 private:
  const FlightLegs& legs_;
};

class FlightMotion : public ob::MotionValidator {
 public:
  FlightMotion(const ob::SpaceInformationPtr& information, const FlightLegs& legs)
      : ob::MotionValidator(information), legs_(legs) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return legs_.can_fly(at(from), at(to));
  }
  /// A leg is flown whole or not at all.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (legs_.can_fly(at(from), at(to))) return true;
    last_valid.second = 0;
    if (last_valid.first != nullptr) at(last_valid.first) = at(from);
    return false;
  }

 private:
  const FlightLegs& legs_;
};

/// The goal's ball, by any heading.
class FlightGoal : public ob::GoalSampleableRegion {
 public:
  FlightGoal(const ob::SpaceInformationPtr& information, const FlightLegs& legs)
      : ob::GoalSampleableRegion(information), legs_(legs) {
    setThreshold(1e-9);  // Closer than this, and inside the ball it is 0.
  }
  double distanceGoal(const ob::State* state) const override {
    const FlightEnd& end = legs_.end();
    const Waypoint& here = at(state);
    const double aside = std::max(0.0, (here.pose.position() - end.place()).norm() - end.radius_m());
    return aside + std::max({0.0, end.low() - here.z, here.z - end.high()});
  }
  /// By a heading that can be come from, if one is found soon: RRTConnect takes few goals, and one that no flight leads
  /// to is all that it has.
  void sampleGoal(ob::State* state) const override {
    for (int i = 0; i < kTries; ++i) {
      draw(state);
      if (legs_.can_approach(at(state))) return;
    }
  }
  /// BIT* draws all of them before it begins.
  unsigned int maxSampleCount() const override { return 64; }

 private:
  void draw(ob::State* state) const {
    const FlightEnd& end = legs_.end();
    const double radius = end.radius_m() * std::sqrt(random_.uniform01()) * (1 - 1e-9);
    const double angle = random_.uniformReal(-kPi, kPi);
    const Vec2 place = end.place() + radius * Vec2(std::cos(angle), std::sin(angle));
    at(state).pose = planar_pose(place.x(), place.y(), random_.uniformReal(-kPi, kPi));
    at(state).z = random_.uniformReal(end.low(), end.high());
  }

  const FlightLegs& legs_;
  mutable ompl::RNG random_;
};

/// States on no way of a given cost or less are left out: an ellipse on the ground.
class InformedFlights : public ob::InformedSampler {
 public:
  InformedFlights(const ob::ProblemDefinitionPtr& definition, unsigned int calls, const FlightLegs& legs)
      : ob::InformedSampler(definition, calls), legs_(legs) {}

  bool sampleUniform(ob::State* state, const ob::Cost& most) override {
    return draw_state(random_, legs_, legs_.most_length(most.value()), at(state));
  }
  bool sampleUniform(ob::State* state, const ob::Cost& least, const ob::Cost& most) override {
    for (unsigned int i = 0; i < numIters_; ++i)
      if (sampleUniform(state, most) && !opt_->isCostBetterThan(heuristicSolnCost(state), least)) return true;
    return false;
  }
  bool hasInformedMeasure() const override { return true; }
  double getInformedMeasure(const ob::Cost& most) const override {
    const double whole = space_->getMeasure();
    const double half = legs_.most_length(most.value()) / 2;
    const double focal = (legs_.mission().goal - legs_.mission().start).head<2>().norm() / 2;
    if (!std::isfinite(half)) return whole;
    const double ellipse = kPi * half * std::sqrt(std::max(1.0, half * half - focal * focal));
    const Vec2 size = legs_.area().max - legs_.area().min;
    return whole * std::min(1.0, ellipse / (size.x() * size.y()));
  }

 private:
  const FlightLegs& legs_;
  ompl::RNG random_;
};

class FlightObjective : public ob::OptimizationObjective {
 public:
  FlightObjective(const ob::SpaceInformationPtr& information, const FlightLegs& legs)
      : ob::OptimizationObjective(information), legs_(legs) {
    setCostToGoHeuristic([&legs](const ob::State* state, const ob::Goal* /*goal*/) {
      return ob::Cost(legs.least_cost_to_goal(at(state)));
    });
  }
  bool isSymmetric() const override { return false; }
  ob::Cost stateCost(const ob::State* /*state*/) const override { return identityCost(); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(legs_.cost(at(from), at(to)));
  }
  ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(legs_.least_cost(at(from), at(to)));
  }
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& definition,
                                                   unsigned int calls) const override {
    return std::make_shared<InformedFlights>(definition, calls, legs_);
  }

 private:
  const FlightLegs& legs_;
};

/// One start for each heading that the flight may begin with.
void add_starts(ob::ProblemDefinition& definition, const FlightSpace& space) {
  const Mission& mission = space.legs().mission();
  const int count = mission.heading_given ? 1 : 16;
  const Vec2 way = (mission.goal - mission.start).head<2>();
  const double first = mission.heading_given ? kPi / 2 - mission.heading_rad : std::atan2(way.y(), way.x());
  ob::State* state = space.allocState();
  for (int k = 0; k < count; ++k) {
    at(state) = {.pose = planar_pose(mission.start.x(), mission.start.y(), first + 2 * kPi * k / count),
                 .z = mission.start.z()};
    definition.addStartState(state);
  }
  space.freeState(state);
}

}  // namespace

FlightSpace::FlightSpace(const FlightLegs& legs) : legs_(legs) { setName("Dubins flights"); }

double FlightSpace::getMaximumExtent() const { return (legs_.area().max - legs_.area().min).norm(); }

double FlightSpace::getMeasure() const {
  constexpr double kAltitudes_m = 500;
  const Vec2 size = legs_.area().max - legs_.area().min;
  return size.x() * size.y() * kAltitudes_m * 2 * kPi;
}

void FlightSpace::enforceBounds(ob::State* state) const {
  Waypoint& here = at(state);
  const Vec2 inside = here.pose.position().cwiseMax(legs_.area().min).cwiseMin(legs_.area().max);
  here.pose.x = inside.x();
  here.pose.y = inside.y();
  if (const auto altitudes = legs_.altitudes(here.pose))
    here.z = std::clamp(here.z, altitudes->first, altitudes->second);
}

bool FlightSpace::satisfiesBounds(const ob::State* state) const {
  return legs_.area().contains(at(state).pose.position());
}

void FlightSpace::copyState(ob::State* destination, const ob::State* source) const { at(destination) = at(source); }

double FlightSpace::distance(const ob::State* from, const ob::State* to) const {
  const Waypoint& a = at(from);
  const Waypoint& b = at(to);
  const SlopeLimits& slopes = legs_.band().slopes();
  const double climb = b.z - a.z;
  return std::max(dubins_length(a.pose, b.pose, legs_.radius_m()),
                  climb > 0 ? climb / slopes.climb : -climb / slopes.descent);
}

bool FlightSpace::equalStates(const ob::State* a, const ob::State* b) const {
  const Waypoint& one = at(a);
  const Waypoint& two = at(b);
  return one.pose.x == two.pose.x && one.pose.y == two.pose.y && one.pose.heading == two.pose.heading && one.z == two.z;
}

void FlightSpace::interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const {
  const Waypoint a = at(from);
  const Waypoint b = at(to);
  const DubinsPath path = shortest_dubins(a.pose, b.pose, legs_.radius_m());
  Waypoint& here = at(state);
  here.pose = t >= 1 ? b.pose : DubinsCursor(path).at(t * path.length_m);
  here.z = a.z + t * (b.z - a.z);
  if (const auto altitudes = legs_.altitudes(here.pose); altitudes && t < 1)
    here.z = std::clamp(here.z, altitudes->first, altitudes->second);
}

ob::StateSamplerPtr FlightSpace::allocDefaultStateSampler() const { return std::make_shared<FlightSampler>(*this); }

ob::State* FlightSpace::allocState() const { return new StateType; }

void FlightSpace::freeState(ob::State* state) const { delete static_cast<StateType*>(state); }

FlightProblem flight_problem(const FlightLegs& legs) {
  FlightProblem made{.space = std::make_shared<FlightSpace>(legs)};
  made.information = std::make_shared<ob::SpaceInformation>(made.space);
  made.information->setStateValidityChecker(std::make_shared<FlightValidity>(made.information, legs));
  made.information->setMotionValidator(std::make_shared<FlightMotion>(made.information, legs));
  made.information->setup();
  made.definition = std::make_shared<ob::ProblemDefinition>(made.information);
  add_starts(*made.definition, *made.space);
  made.definition->setGoal(std::make_shared<FlightGoal>(made.information, legs));
  made.definition->setOptimizationObjective(std::make_shared<FlightObjective>(made.information, legs));
  return made;
}

}  // namespace alate::peers
