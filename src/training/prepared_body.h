#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin {

// The condensed body lies beside the mesh that it was made from, in the case folder.
inline constexpr const char* body_file_name = "body.condensed";

// Gives a case the deformable body that its resistance needs, from the mesh in `folder` and the settings of the
// resistance: condensed now, or read back when that was done before. Does nothing when the resistance needs none.
// `note` hears what was assumed, and what memory the work takes, before it takes it. Throws InputError, one sentence,
// when there is no mesh, and for everything that describe_body() and condense() refuse.
void prepare_body(Case& patient, const std::filesystem::path& folder, const Progress& progress,
                  const std::function<void(const std::string&)>& note);

}  // namespace bodkin
