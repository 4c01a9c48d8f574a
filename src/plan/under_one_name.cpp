#include "plan/under_one_name.hpp"

#include <algorithm>
#include <cassert>
#include <memory>

namespace alate {

namespace {

/// In the order in which they are asked.
struct Entries {
  PlannerEntry main;
  std::vector<SpacePart> others;

  /// Of all planners, main being the last.
  std::size_t index_for(const Site& site) const {
    const auto found = std::ranges::find_if(others, [&](const SpacePart& part) { return part.is_for(site); });
    return static_cast<std::size_t>(found - others.begin());
  }
  const PlannerEntry& entry_for(const Site& site) const {
    const std::size_t index = index_for(site);
    return index < others.size() ? others[index].entry : main;
  }
};

class OnAnySpace {
 public:
  OnAnySpace(std::shared_ptr<const Entries> entries, const ParamValues& values) : entries_(std::move(entries)) {
    for (const SpacePart& part : entries_->others) planners_.push_back(part.entry.make(values));
    planners_.push_back(entries_->main.make(values));
  }

  Plan plan(const Problem& problem, RunContext& run) const {
    return planners_[entries_->index_for(problem.world.site())].plan(problem, run);
  }

 private:
  std::shared_ptr<const Entries> entries_;
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

PlannerEntry under_one_name(PlannerEntry main, std::vector<SpacePart> others) {
  PlannerEntry all = main;
  std::vector<Parameter> parameters = all.parameters.parameters();
  for (const SpacePart& part : others) {
    const PlannerEntry& more = part.entry;
    assert(more.name == all.name);
    all.help += " " + more.help;
    add_abilities(more.can, all.can);
    const auto is_known = [&](const Parameter& one) {
      return std::ranges::find(parameters, one.name, &Parameter::name) != parameters.end();
    };
    for (const Parameter& parameter : more.parameters.parameters())
      if (!is_known(parameter)) parameters.push_back(parameter);
  }
  all.parameters = ParamTable(std::move(parameters));
  const auto entries = std::make_shared<const Entries>(Entries{std::move(main), std::move(others)});
  all.refuses = [entries](const Problem& problem) { return entries->entry_for(problem.world.site()).refuses(problem); };
  all.can_there = [entries](const Site& site) { return entries->entry_for(site).can; };
  all.make = [entries](const ParamValues& values) { return Planner(OnAnySpace(entries, values)); };
  return all;
}

}  // namespace alate
