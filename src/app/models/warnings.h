#pragma once

#include <optional>

#include "views/frame.h"

#include "anatomy/case.h"

namespace bodkin::app {

using namespace views;

// What is wrong where the tip is: bone under pressure, a nerve or the cord, a vessel, an organ, or a structure that
// the case calls critical. `is_on_bone`: the models have met bone and not left it. Nothing where all is well, and in
// the target's own tissue.
std::optional<Warning> warning_at(const anatomy::Case& patient, const Vec3& tip, anatomy::TissueId tissue,
                                  bool is_on_bone);

}  // namespace bodkin::app
