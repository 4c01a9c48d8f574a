#include "alate/plan/point_route.hpp"

#include "alate/core/fault.hpp"
#include "data/point_list.hpp"
#include "space/correction_route.hpp"

namespace alate {

Route route_over_points(const Site& site, const std::string& ids, const std::string& source) {
  RouteThrough through = route_through(site, read_point_ids(site, ids, source));
  if (through.route.empty()) throw InputError(Fault{.file = source, .message = through.why});
  return std::move(through.route);
}

}  // namespace alate
