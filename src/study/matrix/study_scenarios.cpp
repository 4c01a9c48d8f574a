// Scenarios of a study: files, and maps that stand in the study itself.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "alate/data/scenario_file.hpp"
#include "data/limits.hpp"
#include "data/scenario_reader.hpp"
#include "study/matrix/ranges.hpp"
#include "study/matrix/study_parts.hpp"

namespace alate {

namespace {

/// Cells of grids, posts of rasters and voxels.
std::size_t size_of(const Site& site) {
  std::size_t size = site.grid ? site.grid->blocked.size() : 0;
  if (site.voxels) size += site.voxels->count();
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) size += raster->posts.size();
  return size;
}

class ScenarioList {
 public:
  explicit ScenarioList(StudyFaults& faults) : faults_(faults) {}

  /// An item of the study: a group, or a scenario of the group without a name.
  void read(const Node& item, const std::string& field) {
    if (item.kind == Node::Kind::map && item.find("group") != nullptr) return read_group(item, field);
    set_group("");
    read_scenario(item, field);
  }

  ScenarioItems take() { return std::move(items_); }

 private:
  void read_group(const Node& item, const std::string& field) {
    faults_.check_keys(item, field, {"group", "scenarios"});
    const Node* name = item.find("group");
    const Node* list = item.find("scenarios");
    if (!faults_.is_word(*name, field + ".group")) return;
    if (name->text.empty() || std::ranges::find(items_.groups, name->text) != items_.groups.end())
      return faults_.report(name->place,
                            {.field = field + ".group", .value = name->text, .message = "needs a name of its own"});
    if (!faults_.is_list(list, item, field + ".scenarios", kMaxStudyScenarios)) return;
    set_group(name->text);
    for (std::size_t i = 0; i < list->children.size(); ++i)
      read_scenario(list->children[i], fmt::format("{}.scenarios.{}", field, i));
  }

  void set_group(const std::string& name) {
    group_ = static_cast<std::size_t>(std::ranges::find(items_.groups, name) - items_.groups.begin());
    if (group_ == items_.groups.size()) items_.groups.push_back(name);
  }

  void read_scenario(const Node& item, const std::string& field) {
    if (item.kind == Node::Kind::scalar) return read_file(item, field);
    if (item.kind == Node::Kind::map) return read_inline(item, field);
    if (item.kind != Node::Kind::broken)
      faults_.report(item.place, {.field = field, .message = "must be a file or a scenario"});
  }

  void read_file(const Node& item, const std::string& field) {
    if (!faults_.is_word(item, field)) return;
    if (!names_.insert(item.text).second)
      return faults_.report(item.place, {.field = field, .value = item.text, .message = "given twice"});
    const auto file = (std::filesystem::path(faults_.file()).parent_path() / item.text).string();
    try {
      add(item.text, load_scenario(file), item);
    } catch (const InputError& error) {
      faults_.take(error.faults(), field);
    }
  }

  void read_inline(Node item, const std::string& field) {
    set_corners(item);
    const std::size_t room = kMaxStudyScenarios - std::min(items_.scenarios.size(), kMaxStudyScenarios);
    if (room == 0 || expanded_count(item, room) == 0) {
      return faults_.report(item.place,
                            {.field = field,
                             .limit = fmt::format("{}", kMaxStudyScenarios),
                             .unit = "scenarios",
                             .message = "has a range that runs backwards, or the study has too many scenarios"});
    }
    for (const Expanded& each : expand(item)) {
      std::string name = field.substr(field.rfind('.') + 1);
      if (!each.chosen.empty()) name.append(" ").append(each.chosen);
      const std::string& group = items_.groups[group_];
      name = group.empty() ? fmt::format("scenario {}", name) : fmt::format("{}: {}", group, name);
      if (!read_one(each.node, name, field)) return;  // The others would fail in the same way.
    }
  }

  bool read_one(const Node& node, const std::string& name, const std::string& field) {
    try {
      std::vector<Fault> found;
      Scenario scenario = scenario_of(node, faults_.file(), found);
      throw_if_any(std::move(found));
      return add(name, std::move(scenario), node);
    } catch (const InputError& error) {
      faults_.take(error.faults(), field);
      return false;
    }
  }

  /// The planners of the study are the study's, not those that a scenario asks for.
  bool add(const std::string& name, Scenario scenario, const Node& item) {
    scenario.planner.reset();
    Site site = load_site(scenario);
    size_ += size_of(site);
    if (size_ > kMaxStudyCells) {
      faults_.report(item.place, {.limit = fmt::format("{}", kMaxStudyCells),
                                  .unit = "cells",
                                  .message = "the scenarios of the study hold too much ground"});
      return false;
    }
    items_.scenarios.push_back({.name = name, .world = World(std::move(site)), .group = group_});
    return true;
  }

  /// A random grid alone is flown from the lower left to the upper right, as in the papers that draw them.
  static void set_corners(Node& item) {
    const Node* grid = item.find("grid");
    const Node* random = grid == nullptr ? nullptr : grid->find("random");
    const Node* size = random == nullptr ? nullptr : random->find("size");
    if (size == nullptr || size->children.size() != 2 || item.find("start") != nullptr || item.find("goal") != nullptr)
      return;
    const auto number = [&](std::size_t i) { return std::strtol(size->children[i].text.c_str(), nullptr, 10); };
    if (range_of(size->children[0]) || range_of(size->children[1]) || number(0) < 1 || number(1) < 1) return;
    const Place place = size->place;
    item.children.push_back(corner("start", {0, number(1) - 1}, place));
    item.children.push_back(corner("goal", {number(0) - 1, 0}, place));
  }

  static Node corner(const std::string& key, const std::pair<long, long>& cell, const Place& place) {
    const auto scalar = [&](long value) {
      return Node{.kind = Node::Kind::scalar, .text = std::to_string(value), .place = place};
    };
    Node at{.kind = Node::Kind::list, .key = "cell", .key_place = place, .place = place};
    at.children = {scalar(cell.first), scalar(cell.second)};
    Node end{.kind = Node::Kind::map, .key = key, .key_place = place, .place = place};
    end.children = {std::move(at)};
    return end;
  }

  StudyFaults& faults_;
  ScenarioItems items_;
  std::size_t group_ = 0;
  std::set<std::string> names_;
  std::size_t size_ = 0;
};

}  // namespace

ScenarioItems read_study_scenarios(const Node& list, StudyFaults& faults) {
  ScenarioList scenarios(faults);
  for (std::size_t i = 0; i < list.children.size(); ++i)
    scenarios.read(list.children[i], fmt::format("scenarios.{}", i));
  return scenarios.take();
}

}  // namespace alate
