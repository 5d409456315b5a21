#pragma once

#include <nlohmann/json_fwd.hpp>

#include "anatomy/case.h"

namespace bodkin::cli {

// Every parameter under the name that its table gives it, with its unit in the name as in files; settings inside are
// objects, elements of which there may be several are arrays of objects. Of a model that another program registered
// the values are texts, for its table is not known here.
nlohmann::json settings_json(const anatomy::Needle& needle);
nlohmann::json settings_json(const anatomy::DeviceLimits& device);
nlohmann::json settings_json(const anatomy::TissueProperties& tissue);
nlohmann::json settings_json(const anatomy::ResistanceSettings& resistance);
nlohmann::json settings_json(const anatomy::ConstraintSettings& constraint);

}  // namespace bodkin::cli
