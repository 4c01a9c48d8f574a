// The runs of a study on disk, one line each, so that a study that was killed goes on where it stood.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "alate/study/study.hpp"
#include "out/output_folder.hpp"

namespace alate {

/// One rank's file, `journal-RANK.jsonl`: each line is a checksum, a blank and JSON. The first names the study. A line
/// counts if it is whole, ends, and its checksum is right; from the first that does not, the rest is forgotten.
class Journal {
 public:
  /// Cuts off a torn end, and begins a file that is new or empty. Throws InputError if it cannot be opened.
  Journal(const std::string& folder, std::size_t rank, const Study& study);

  /// One write for the whole line: a killed process leaves it or a torn one. Throws std::system_error.
  void add(std::size_t job, const StudyRecord& record);

 private:
  void write_line(const std::string& json);

  std::filesystem::path file_;
  Descriptor descriptor_;
};

}  // namespace alate
