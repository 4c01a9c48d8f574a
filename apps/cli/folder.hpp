// The folder of --out.
#pragma once

#include <filesystem>

#include "options.hpp"

namespace alate::cli {

/// Faults that show before anything is made: a file in the way, or a folder that may not be written.
void check_folder(const std::filesystem::path& folder, FaultList& faults);

/// Made before planning, so that no long run is lost to a folder that cannot be. Throws InputError.
void make_folder(const std::filesystem::path& folder);

}  // namespace alate::cli
