// The reproduction of Konatowski and Pawlowski 2019, from runs to page.
#pragma once

#include "alate/study/reproduce.hpp"

namespace alate::konatowski2019 {

/// Nothing if it was stopped.
std::optional<Reproduction> reproduce(Executor& executor, const ReproduceOptions& options);

}  // namespace alate::konatowski2019
