// YAML as a plain tree: what stands in the text, before anything is known about scenarios.
#pragma once

#include <string>
#include <vector>

#include "alate/core/fault.hpp"

namespace alate {

/// Where a node stands; line 0 for what an override gave.
struct Place {
  int line = 0;
  int column = 0;
};

/// One value with its key, if it stands in a map.
struct Node {
  enum class Kind { null, scalar, list, map, broken };  ///< broken: its fault is already reported.
  Kind kind = Kind::null;
  std::string key;
  Place key_place;
  std::string text;     ///< Of a scalar.
  bool quoted = false;  ///< The scalar stood in quotes: text, never a number.
  Place place;
  std::vector<Node> children;

  const Node* find(const std::string& name) const;
  Node* find(const std::string& name);
};

/// Parses one YAML document. Faults: wrong syntax (line and column), keys given twice (the first one counts), keys
/// that are no words, aliases and tags, nesting beyond the limit, more than one document. Always ends: aliases,
/// which could multiply without end, are refused.
Node parse_document(const std::string& text, const std::string& file, std::vector<Fault>& faults);

}  // namespace alate
