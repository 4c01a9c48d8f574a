// Legs that are free whoever asks: above analytic hills World and `check` each know the height of a leg to 0.05 m on
// the safe side, by different means, so a leg that hugs the ground might be free for one and not for the other.
#pragma once

#include "alate/world/world.hpp"

namespace alate {

/// What to add to limits above ground, metres.
double hill_slack_m(const Site& site);

/// Is the leg free, with that slack to ground and ceiling?
bool is_surely_free(const World& world, const Segment& leg);

}  // namespace alate
