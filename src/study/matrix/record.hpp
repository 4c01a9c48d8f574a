// What is kept of a run, and how it stands in a journal.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "alate/study/study.hpp"
#include "study/run_loop.hpp"

namespace alate {

StudyRecord record_of(const StudyRun& run);

nlohmann::json to_json_value(const StudyRecord& record);
/// Throws nlohmann::json::exception if the value is none.
StudyRecord record_from(const nlohmann::json& json);

}  // namespace alate
