#pragma once

#include <filesystem>
#include <vector>

#include "views/measures.h"

namespace bodkin::app {

// What was measured in a patient stays with him, in `measures.json` of his folder. Without one, or with one that is
// damaged, there are none.
std::vector<views::Measure> kept_measures(const std::filesystem::path& folder);
// No file where there is nothing to keep. Throws SystemError.
void keep_measures(const std::vector<views::Measure>& measures, const std::filesystem::path& folder);

}  // namespace bodkin::app
