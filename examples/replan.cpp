// Replanning in flight: a threat pops up ahead of the aircraft, and a way round it is found while it flies.
//
//   replan examples/jacksboro/scenario.yaml
#include <alate/alate.hpp>
#include <exception>
#include <iostream>

namespace {

int fly(const char* scenario_file) {
  // 1. A session keeps what a plan needs, so that the next one is quicker. It serves one aircraft.
  alate::Session session(alate::load_site(alate::load_scenario(scenario_file)));
  alate::Executor executor(1);
  alate::RunContext first(executor, {.iterations = 10});
  const alate::Plan plan = session.plan(first);
  if (plan.route.empty()) {
    std::cout << "no route: " << plan.why << '\n';
    return 1;
  }
  std::cout << "planned: cost " << plan.cost << " m\n";

  // 2. After 3 km of flight a threat is seen 5 km ahead, right on the route.
  const alate::FlightState now = *alate::state_along(plan.route, 3000);
  const alate::Vec3 ahead = alate::state_along(plan.route, 8000)->position;
  std::vector<alate::Threat> threats = session.site().threats;
  threats.push_back({.name = "pop-up", .center = ahead, .radius_m = 1500, .level = 0.8, .core_m = 1000});

  // 3. Replan. The first iteration gives the quickest answer, the others better ones until the time is up.
  alate::RunContext second(executor, {.iterations = 1});
  const alate::Plan round = session.replan(now, {.threats = threats}, second);
  const double wall_ms = 1e3 * second.elapsed_s();

  // 4. The site is now the changed one, with its start at the aircraft: what the check judges by.
  const bool old_is_good = alate::check(session.site(), alate::rest_of(plan.route, now.flown_m)).ok();
  const bool new_is_good = !round.route.empty() && alate::check(session.site(), round.route).ok();
  std::cout << "the old route may " << (old_is_good ? "still" : "not") << " be flown on\n";
  std::cout << "replanned within " << wall_ms << " ms: cost " << round.cost << " m, "
            << (new_is_good ? "passes" : "does not pass") << " the check\n";
  return new_is_good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: replan SCENARIO\n";
    return 2;
  }
  try {
    return fly(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
