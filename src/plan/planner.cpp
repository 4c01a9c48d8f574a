#include "alate/plan/planner.hpp"

namespace alate {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::optimal:
      return "optimal";
    case Outcome::feasible:
      return "feasible";
    case Outcome::infeasible_proven:
      return "infeasible_proven";
    case Outcome::none_found:
      return "none_found";
  }
  return "";
}

}  // namespace alate
