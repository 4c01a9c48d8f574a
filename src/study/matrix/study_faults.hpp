// Faults of a study file while it is read.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "data/scenario_document.hpp"

namespace alate {

class StudyFaults {
 public:
  explicit StudyFaults(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }
  std::vector<Fault>& all() { return faults_; }
  bool none() const { return faults_.empty(); }

  /// Adds the file and the place to the fault.
  void report(const Place& place, Fault fault);
  /// Faults that another reader found; those in this file are of `field`.
  void take(std::vector<Fault> faults, const std::string& field);

  /// Every key of a map must be one of `known`: the nearest is named.
  void check_keys(const Node& map, const std::string& field, const std::vector<std::string>& known);
  /// Has the node items, up to `most`? Reports what is wrong if not; a node that is missing is reported at `around`.
  bool is_list(const Node* node, const Node& around, const std::string& field, std::size_t most);
  /// A scalar without a fault of its own.
  bool is_word(const Node& node, const std::string& field);

  /// In the order of the text, no more than a person reads.
  void throw_if_any();

 private:
  std::string file_;
  std::vector<Fault> faults_;
};

}  // namespace alate
