// Real data beside the checkout (`../shared/data`), which is not part of the repository.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace alate::test {

/// Folder of the shared data: $ALATE_SHARED_DATA, or ../shared/data beside the source folder.
inline std::filesystem::path shared_data_folder() {
  if (const char* folder = std::getenv("ALATE_SHARED_DATA")) return folder;
  return std::filesystem::path(ALATE_SOURCE_DIR).parent_path() / "shared" / "data";
}

inline std::filesystem::path shared_data(const std::string& file) { return shared_data_folder() / file; }

}  // namespace alate::test

/// Skips the test, loudly, where the shared data are absent.
#define ALATE_NEEDS_SHARED_DATA(file)                           \
  if (!std::filesystem::exists(alate::test::shared_data(file))) \
  GTEST_SKIP() << "SKIPPED: needs " << alate::test::shared_data(file)
