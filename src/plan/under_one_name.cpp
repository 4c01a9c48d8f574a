#include "plan/under_one_name.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace alate {

namespace {

const SpacePart& part_for(const std::vector<SpacePart>& parts, const Site& site) {
  const auto last = std::prev(parts.end());
  return *std::find_if(parts.begin(), last, [&](const SpacePart& part) { return part.is_for(site); });
}

class OnAnySpace {
 public:
  OnAnySpace(std::shared_ptr<const std::vector<SpacePart>> parts, const ParamValues& values)
      : parts_(std::move(parts)) {
    for (const SpacePart& part : *parts_) planners_.push_back(part.entry.make(values));
  }

  Plan plan(const Problem& problem, RunContext& run) const {
    const auto part = &part_for(*parts_, problem.world.site()) - parts_->data();
    return planners_[static_cast<std::size_t>(part)].plan(problem, run);
  }

 private:
  std::shared_ptr<const std::vector<SpacePart>> parts_;
  std::vector<Planner> planners_;
};

void add_abilities(const Abilities& more, Abilities& all) {
  all.exact = all.exact || more.exact;
  all.anytime = all.anytime || more.anytime;
  all.deterministic = all.deterministic && more.deterministic;
  all.terrain = all.terrain || more.terrain;
  all.threats = all.threats || more.threats;
  all.voxels = all.voxels || more.voxels;
  all.space += ", " + more.space;
}

}  // namespace

PlannerEntry under_one_name(std::vector<SpacePart> parts) {
  assert(!parts.empty());
  PlannerEntry all = parts.front().entry;
  std::vector<Parameter> parameters = all.parameters.parameters();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const PlannerEntry& more = parts[i].entry;
    assert(more.name == all.name);
    all.help += " " + more.help;
    add_abilities(more.can, all.can);
    for (const Parameter& parameter : more.parameters.parameters())
      if (all.parameters.find(parameter.name) == nullptr) parameters.push_back(parameter);
    if (all.fits.empty()) all.fits = more.fits;
  }
  all.parameters = ParamTable(std::move(parameters));
  const auto shared = std::make_shared<const std::vector<SpacePart>>(std::move(parts));
  all.refuses = [shared](const Problem& problem) {
    return part_for(*shared, problem.world.site()).entry.refuses(problem);
  };
  all.make = [shared](const ParamValues& values) { return Planner(OnAnySpace(shared, values)); };
  return all;
}

}  // namespace alate
