// Dubins flights as a space, a goal and an objective of OMPL.
//
// Distances and ways differ with the direction, so the space is no metric one and says so. Altitudes are sampled inside
// the band at the place that was drawn: over the whole range of altitudes nearly every state would be invalid.
#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSpace.h>

#include "flight_legs.hpp"

namespace alate::peers {

namespace ob = ompl::base;

class FlightSpace : public ob::StateSpace {
 public:
  class StateType : public ob::State {
   public:
    Waypoint at;
  };

  explicit FlightSpace(const FlightLegs& legs);

  const FlightLegs& legs() const { return legs_; }
  /// From now on samples lie where a way no longer than this can lead.
  void set_most_length(double length_m) { most_length_m_ = length_m; }
  double most_length() const { return most_length_m_; }

  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }
  unsigned int getDimension() const override { return 4; }
  double getMaximumExtent() const override;
  double getMeasure() const override;
  void enforceBounds(ob::State* state) const override;
  bool satisfiesBounds(const ob::State* state) const override;
  void copyState(ob::State* destination, const ob::State* source) const override;
  /// What must be flown at least, climbing included.
  double distance(const ob::State* from, const ob::State* to) const override;
  bool equalStates(const ob::State* a, const ob::State* b) const override;
  void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override;
  ob::StateSamplerPtr allocDefaultStateSampler() const override;
  ob::State* allocState() const override;
  void freeState(ob::State* state) const override;

 private:
  const FlightLegs& legs_;
  double most_length_m_ = std::numeric_limits<double>::infinity();
};

inline const Waypoint& at(const ob::State* state) { return static_cast<const FlightSpace::StateType*>(state)->at; }
inline Waypoint& at(ob::State* state) { return static_cast<FlightSpace::StateType*>(state)->at; }

/// Space, validity, start, goal and objective, ready for any planner of OMPL.
struct FlightProblem {
  std::shared_ptr<FlightSpace> space;
  ob::SpaceInformationPtr information;
  ob::ProblemDefinitionPtr definition;
};

/// `legs` must outlive it.
FlightProblem flight_problem(const FlightLegs& legs);

}  // namespace alate::peers
