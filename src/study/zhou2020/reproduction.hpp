// Zhou et al. 2020 and its peers put to the test.
#pragma once

#include <optional>

#include "alate/study/reproduce.hpp"

namespace alate::zhou2020 {

/// Nothing if stopped. Throws InputError if the contest's points are not in `options.data`.
std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options);

}  // namespace alate::zhou2020
