// Faults and marks of one reading.
#pragma once

#include <string>
#include <vector>

#include "alate/core/scenario.hpp"
#include "data/scenario_document.hpp"
#include "data/scenario_fields.hpp"

namespace alate {

/// One value under its dotted path, with the field it is read for.
struct Value {
  const Node& node;
  const std::string& path;
  const Field& field;
};

/// Collects what is found while a tree is read into `scenario`.
class Findings {
 public:
  Findings(Scenario& scenario, std::vector<Fault>& faults) : scenario_(scenario), faults_(faults) {}

  const std::string& file() const { return scenario_.file; }
  void mark(const std::string& path, const Place& place) { scenario_.marks[path] = mark_at(place); }
  void report(const Place& place, Fault fault);
  void report(const Value& value, std::string message, std::string limit = "");

 private:
  Mark mark_at(const Place& place) const;

  Scenario& scenario_;
  std::vector<Fault>& faults_;
};

inline std::string join(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

// Each stores the value by its slot, or reports why not.
void read_value(const Value& value, const Text& slot, Findings& findings);
void read_value(const Value& value, const Flag& slot, Findings& findings);
void read_value(const Value& value, const Number& slot, Findings& findings);
void read_value(const Value& value, const Numbers& slot, Findings& findings);
void read_value(const Value& value, const Choice& slot, Findings& findings);
void read_value(const Value& value, const Words& slot, Findings& findings);

/// Is the node of this kind? Reports `message` if not.
bool is_kind(const Value& value, Node::Kind kind, const char* message, Findings& findings);
/// Has the list so many items? Reports the count if not.
bool has_items(const Value& value, std::size_t least, std::size_t most, Findings& findings);

}  // namespace alate
