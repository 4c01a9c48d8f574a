#include "plan/flight/correction_legs.hpp"

#include <cmath>

#include "alate/core/along_route.hpp"
#include "search/interval/flight_path.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/flight/flight_air.hpp"

namespace alate {

namespace {

constexpr double kEpsilon = 1.15;
constexpr std::uint64_t kMostNodes = 200'000;
constexpr int kTrials = 250;

Site site_towards(const Site& site, const Vec3& place, double tolerance_m) {
  Site towards = site;
  towards.navigation.reset();
  towards.mission.goal = place;
  towards.mission.tolerance_m = tolerance_m;
  return towards;
}

}  // namespace

struct CorrectionLegs::Target {
  Target(const Site& site, const Vec3& place, double tolerance_m, RunContext& run)
      : air(World(site_towards(site, place, tolerance_m))),
        to_go(air.world, air.band.slopes(), run),
        search(air.cost, to_go),
        end(flight_end(place, tolerance_m)) {}

  FlightAir air;
  ClimbField to_go;
  IntervalAStar search;
  FlightEnd end;
};

CorrectionLegs::CorrectionLegs(const Site& site, RunContext& run) : site_(site), run_(run) {}

CorrectionLegs::~CorrectionLegs() = default;

std::optional<FlownLeg> CorrectionLegs::fly(const FlightStart& start, int name, const Vec3& place, double tolerance_m) {
  std::unique_ptr<Target>& target = targets_[name];
  if (target == nullptr) target = std::make_unique<Target>(site_, place, tolerance_m, run_);
  const Vec3 from(start.poses[0].x, start.poses[0].y, start.label.low);
  const IntervalSearchOptions options{.epsilon = kEpsilon,
                                      .bin_m = bin_width((place - from).norm(), target->air.band.radius_m()),
                                      .most_nodes = kMostNodes};
  const auto track = target->search.find(start, target->end, options, run_);
  if (!track || track->empty()) return std::nullopt;
  FlightPath path(target->air.cost, target->end, *track, from.z());
  path.shorten(run_);
  Stream random(run_.seed(), 0, static_cast<std::uint64_t>(name));
  path.better(random, kTrials, run_);
  const Track best = path.track();
  auto route = fly_track(target->air.cost, best, from, path.end());
  if (!route) return std::nullopt;
  if (tolerance_m <= 0) route->states.back().position = place;  // which the track meets to rounding
  FlownLeg leg{.route = std::move(*route), .end = best.back().end()};
  leg.length_m = flown_length(leg.route);
  leg.cost = target->air.objective.route_cost(leg.route);
  return leg;
}

}  // namespace alate
