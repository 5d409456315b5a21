#pragma once

#include <string>

namespace bodkin::app {

// What people call the procedure that a case names: the title in its file, "CT-guided biopsy" for "ct_guided_biopsy";
// of one that does not come with Bodkin the name itself, without underscores.
std::string procedure_title(const std::string& name);

}  // namespace bodkin::app
