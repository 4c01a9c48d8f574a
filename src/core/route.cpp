#include "alate/core/route.hpp"

namespace alate {

const char* to_string(LegKind kind) {
  switch (kind) {
    case LegKind::start:
      return "start";
    case LegKind::straight:
      return "straight";
    case LegKind::arc:
      return "arc";
    case LegKind::climb:
      return "climb";
  }
  return "";
}

}  // namespace alate
