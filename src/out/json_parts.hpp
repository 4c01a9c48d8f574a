// Pieces of JSON that several results hold.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Null for nothing and for what is not finite.
nlohmann::ordered_json number(const std::optional<double>& value);

/// The states of a route as in result.json.
nlohmann::ordered_json route_json(const Site& site, const Route& route);

}  // namespace alate
