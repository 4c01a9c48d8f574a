// A study by its groups of scenarios.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "alate/study/study.hpp"

namespace alate {

/// One group as a study of its own: its scenarios, the planners that serve them, and their runs.
struct StudyPart {
  std::string name;  ///< Of the group; empty where the study makes none.
  Study study;
  StudyRecords records;
  std::vector<std::pair<std::string, std::string>> refused;  ///< Planners that do not serve it, and why.
};

std::vector<StudyPart> parts_of(const Study& study, const StudyRecords& records);

}  // namespace alate
