// The reproduction of Mai et al. 2023, from runs to page.
#pragma once

#include "alate/study/reproduce.hpp"

namespace alate::mai2023 {

/// Nothing if it was stopped.
std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options);

}  // namespace alate::mai2023
