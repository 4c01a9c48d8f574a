#include <fmt/ranges.h>

#include <array>

#include "alate/data/scenario_file.hpp"
#include "data/scenario_fields.hpp"

namespace alate {

namespace {

constexpr const char* kIntroduction = R"(# Scenario files

A scenario is one YAML file; JSON is YAML, too. `alate init` writes a commented one.
`docs/scenario.schema.json` is the same table as a JSON Schema, which editors use to check while you type.
Both are written by `alate schema`; do not edit them.

- Lengths are metres, angles degrees, heights above mean sea level unless a key says `agl`.
- The frame has x east, y north, z up. `lat` and `lon` are WGS 84.
- A relative path starts at the folder of the scenario file; in an `--override`, at the current folder.
- All faults of a file are reported at once, each with line and column. Unknown keys, and keys given twice, are faults.
- Numbers are plain decimal numbers: `010`, `0x10`, `.inf`, `.nan` and numbers in quotes are refused.
- YAML aliases and tags are refused.
- `--override key.path=VALUE` sets a value before the file is read. List items are named by their index, from 0; the
  index equal to the size appends: `--override threats.0.radius_m=500`.
)";

/// Section of one group; sections of groups inside it follow.
class Manual {
 public:
  std::string section(const std::string& path, const Description& description) {
    std::string text = "\n| key | type | unit | default | allowed | meaning |\n|---|---|---|---|---|---|\n";
    for (const Field& field : description.fields) text += row(field);
    if (!description.one_of.empty())
      text += fmt::format("\nGive exactly one of these sets of keys: {}.\n", code(description.one_of));
    for (const Field& field : description.fields) text += inner_section(path + field.key, field);
    return text;
  }

 private:
  static std::string row(const Field& field) {
    const auto cells = std::visit([](const auto& slot) { return cells_of(slot); }, field.slot);
    const std::string needed = field.unless.empty() ? "required" : fmt::format("required without `{}`", field.unless);
    return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", field.key, cells[0], field.unit,
                       field.required ? needed : cells[1], cells[2], field.help);
  }

  std::string inner_section(const std::string& path, const Field& field) {
    const std::string title = fmt::format("\n## `{}`\n\n{}\n", path, field.help);
    if (const auto* group = std::get_if<Group>(&field.slot)) return title + section(path + ".", group->open());
    if (const auto* groups = std::get_if<Groups>(&field.slot)) return title + section(path + "[].", groups->at(0));
    if (const auto* list = std::get_if<FileOrGroups>(&field.slot))
      return title + section(path + "[].", list->items.at(0));
    return "";
  }

  /// Type, default, allowed.
  using Cells = std::array<std::string, 3>;

  static Cells cells_of(const Text& slot) {
    return {slot.use == Text::Use::path ? "path" : "text", slot.value.value_or(""), ""};
  }
  static Cells cells_of(const Flag& slot) { return {"flag", slot.value ? "true" : "false", "true, false"}; }
  static Cells cells_of(const Number& slot) {
    return {slot.whole ? "whole number" : "number", slot.value ? fmt::format("{}", *slot.value) : "",
            slot.range.text()};
  }
  static Cells cells_of(const Numbers& slot) {
    const std::string count = slot.least() == slot.most() ? fmt::format("{}", slot.most())
                                                          : fmt::format("{} to {}", slot.least(), slot.most());
    return {fmt::format("list of {} {}numbers", count, slot.whole ? "whole " : ""), "", slot.range.text()};
  }
  static Cells cells_of(const Choice& slot) {
    return {"word", slot.words[slot.value], fmt::format("{}", fmt::join(slot.words, ", "))};
  }
  static Cells cells_of(const Group& /*slot*/) { return {"group", "", ""}; }
  static Cells cells_of(const Groups& /*slot*/) {
    return {"list of groups", "", fmt::format("0 to {}", kMaxListItems)};
  }
  static Cells cells_of(const FileOrGroups& slot) {
    return {"path or list of groups", "", fmt::format("{} to {} in a list", slot.items.least, kMaxListItems)};
  }
  static Cells cells_of(const Words& /*slot*/) { return {"group of any keys", "", ""}; }

  static std::string code(const std::vector<std::vector<std::string>>& one_of) {
    std::vector<std::string> sets;
    for (const auto& keys : one_of)
      sets.push_back(keys.empty() ? "none of them" : fmt::format("`{}`", fmt::join(keys, "` + `")));
    return fmt::format("{}", fmt::join(sets, ", or "));
  }
};

std::string limits() {
  return fmt::format(
      "\n## Limits\n\n| what | at most |\n|---|---|\n"
      "| bytes of a file | {} |\n| groups and lists within each other | {} |\n| threats, peaks | {} each |\n"
      "| cells of a grid; columns, rows | {}; {} each |\n| voxels; along an axis | {}; {} each |\n"
      "| angles in one list | {} |\n| rolls times pitches times yaws | {} |\n| any number | {} either side of 0 |\n",
      kMaxScenarioBytes, kMaxNesting, kMaxListItems, kMaxGridCells, kMaxGridSide, kMaxVoxels, kMaxVoxelSide, kMaxAngles,
      kMaxAttitudeMoves, kMaxMagnitude);
}

}  // namespace

std::string scenario_manual() {
  Scenario fresh;
  return fmt::format("{}\n## Keys\n{}{}\n## Example\n\n```yaml\n{}```\n", kIntroduction,
                     Manual().section("", describe(fresh)), limits(), scenario_template());
}

}  // namespace alate
