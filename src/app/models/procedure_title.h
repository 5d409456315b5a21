#pragma once

#include <string>

namespace bodkin::app {

// The display name of a case's procedure: the title in its file, "CT-guided biopsy" for "ct_guided_biopsy"; for one
// not supplied with Bodkin, its name without underscores.
std::string procedure_title(const std::string& name);

}  // namespace bodkin::app
