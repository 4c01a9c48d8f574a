// All planners by name, what each can do, and the choice between them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "alate/core/param_table.hpp"
#include "alate/plan/planner.hpp"

namespace alate {

/// What a planner promises.
struct Abilities {
  bool exact = false;          ///< Proves its answer optimal on its own space.
  bool anytime = false;        ///< Uses a longer time limit to improve.
  bool deterministic = false;  ///< The seed changes nothing.
  bool terrain = false;        ///< Rounds terrain.
  bool threats = false;
  bool voxels = false;  ///< Serves voxel maps beside its space.
  std::string space;    ///< "attitude lattice", ...
};

struct Preset {
  std::string name;
  std::string help;
  std::map<std::string, ParamValue> values;  ///< What differs from the defaults.
};

struct PlannerEntry {
  std::string name;
  std::string help;
  Abilities can;
  std::vector<Preset> presets;  ///< The first is the default.
  ParamTable parameters;
  /// Empty if the planner can serve this problem, else a plain sentence why it cannot.
  std::function<std::string(const Problem&)> refuses;
  std::function<Planner(const ParamValues&)> make;
  std::string fits;  ///< Why automatic choice takes it; empty: it is the first that can serve.
  /// What it can do on a site, for a planner of several spaces; `can` is then all that it can anywhere.
  std::function<Abilities(const Site&)> can_there = nullptr;

  Abilities can_on(const Site& site) const { return can_there ? can_there(site) : can; }
  const Preset* find_preset(std::string_view preset) const;
};

class Registry {
 public:
  void add(PlannerEntry entry);
  const std::vector<PlannerEntry>& entries() const { return entries_; }
  const PlannerEntry* find(std::string_view name) const;
  std::vector<std::string> names() const;

 private:
  std::vector<PlannerEntry> entries_;
};

/// The planners that alate ships.
const Registry& builtin_planners();

/// What the user asked for on the command line; empty parts were not given.
struct PlannerRequest {
  std::string name;
  std::string preset;
  std::vector<ParamSetting> settings;
};

/// A planner ready to run, and how it was picked.
struct ChosenPlanner {
  std::string name;
  std::string preset;
  std::string chosen_by;  ///< "option", "scenario" or "auto".
  std::string why;        ///< One plain sentence.
  ParamValues parameters;
  Planner planner;
};

/// Option beats scenario beats automatic choice. Throws InputError for unknown names, parameters out of range,
/// or a planner that cannot serve the problem.
ChosenPlanner choose_planner(const Registry& registry, const Problem& problem, const PlannerRequest& request);

}  // namespace alate
