#include "folder.hpp"

#include <unistd.h>

namespace alate::cli {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder, FaultList& faults) {
  std::error_code ignored;
  fs::path nearest = fs::absolute(folder).lexically_normal();
  while (!fs::exists(nearest, ignored) && nearest != nearest.root_path()) nearest = nearest.parent_path();
  if (!fs::is_directory(nearest, ignored))
    faults.add({.file = "--out", .value = folder.string(), .message = nearest.string() + " is not a folder"});
  else if (access(nearest.c_str(), W_OK | X_OK) != 0)
    faults.add({.file = "--out", .value = folder.string(), .message = nearest.string() + " cannot be written to"});
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(
        Fault{.file = "--out", .value = folder.string(), .message = "the folder cannot be made: " + error.message()});
}

}  // namespace alate::cli
