#include "alate/core/version.hpp"

namespace alate {

std::string version() { return ALATE_VERSION; }

}  // namespace alate
