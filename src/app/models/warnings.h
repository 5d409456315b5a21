#pragma once

#include <optional>

#include "views/frame.h"

#include "anatomy/case.h"

namespace bodkin::app {

using namespace views;

// The danger at the tip: bone under pressure, a nerve or the cord, a vessel, an organ, or a structure that the case
// marks as critical. `is_on_bone`: the models have detected bone contact that has not ended. Empty if there is no
// danger, and in the target's own tissue.
std::optional<Warning> warning_at(const anatomy::Case& patient, const Vec3& tip, anatomy::TissueId tissue,
                                  bool is_on_bone);

}  // namespace bodkin::app
