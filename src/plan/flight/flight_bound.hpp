// What can be proven of a flight over real ground: what it costs at the least, or that there is none.
#pragma once

#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"

namespace alate {

/// How much work a lower bound is worth: about 10 ms, or some tenths of a second.
enum class BoundEffort { quick, tight };

/// A first look: where no flight can exist, the outcome becomes infeasible_proven and `why` tells where. About a
/// millisecond.
void note_barrier(const Problem& problem, RunContext& run, Plan& plan);

/// Raises the plan's lower bound as far as the effort allows; looks more closely for barriers if the plan has no route.
/// Where only unknown ground might hide a way, it is said in `why`.
void note_bound(const Problem& problem, BoundEffort effort, RunContext& run, Plan& plan);

}  // namespace alate
