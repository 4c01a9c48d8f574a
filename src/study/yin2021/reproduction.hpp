// The reproduction of Yin et al. 2021, from runs to page.
#pragma once

#include "alate/study/reproduce.hpp"

namespace alate::yin2021 {

/// Nothing if it was stopped.
std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options);

}  // namespace alate::yin2021
