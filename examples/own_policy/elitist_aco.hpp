// The planner of docs/write-your-own-planner.md.
#pragma once

#include "alate/plan/registry.hpp"

alate::PlannerEntry elitist_aco_entry();
