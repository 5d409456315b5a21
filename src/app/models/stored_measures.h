#pragma once

#include <filesystem>
#include <vector>

#include "views/measures.h"

namespace bodkin::app {

// Measurements in a patient are stored with the patient, in `measures.json` of the case folder. None if the file is
// missing or damaged.
std::vector<views::Measure> stored_measures(const std::filesystem::path& folder);
// Writes no file without measurements. Throws SystemError.
void store_measures(const std::vector<views::Measure>& measures, const std::filesystem::path& folder);

}  // namespace bodkin::app
