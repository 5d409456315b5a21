#pragma once

#include <nlohmann/json_fwd.hpp>

#include "anatomy/case.h"

namespace bodkin::cli {

// Every parameter under the name in its table, with its unit in the name as in files; nested settings are objects,
// repeatable elements are arrays of objects. For a model registered by another program the values are texts, because
// its table is not known here.
nlohmann::json settings_json(const anatomy::Needle& needle);
nlohmann::json settings_json(const anatomy::DeviceLimits& device);
nlohmann::json settings_json(const anatomy::TissueProperties& tissue);
nlohmann::json settings_json(const anatomy::ResistanceSettings& resistance);
nlohmann::json settings_json(const anatomy::ConstraintSettings& constraint);

}  // namespace bodkin::cli
