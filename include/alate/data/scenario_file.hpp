// Scenario files: read with every fault at once, written back, and described (schema, manual, template).
#pragma once

#include <string>
#include <vector>

#include "alate/core/scenario.hpp"

namespace alate {

/// Reads a YAML (or JSON) scenario file; "-" is standard input. `overrides` are `key.path=VALUE` with a YAML
/// value. Paths inside the file are relative to it, those of overrides to the current folder.
/// Throws InputError with every fault: syntax, unknown keys (the nearest known one is named), keys given twice,
/// wrong types, numbers that are not finite or out of range, octal-looking numbers, missing keys.
Scenario load_scenario(const std::string& file, const std::vector<std::string>& overrides = {});

/// As load_scenario, from text. `file` is what faults name, and paths are relative to its folder.
Scenario parse_scenario(const std::string& text, const std::string& file,
                        const std::vector<std::string>& overrides = {});

/// YAML that parse_scenario reads back to an equal scenario, under a file name without a folder: paths are written
/// as they were resolved.
std::string to_yaml(const Scenario& scenario);

/// JSON Schema (draft 2020-12) of scenario files.
std::string scenario_json_schema();

/// The body of docs/scenario.md: every key with type, unit, default, limits and meaning.
std::string scenario_manual();

/// A commented scenario to start from, as `alate init` writes it. It is valid as it stands.
std::string scenario_template();

}  // namespace alate
