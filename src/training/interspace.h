#pragma once

#include <optional>
#include <string>

#include "anatomy/case.h"

namespace bodkin::training {

// The position of a point on the skin relative to the interspaces of a case: its landmarks called NAME_skin, where
// the planned path through each interspace enters the skin.
struct SkinPlace {
  std::string level;     // the nearest interspace: "L3_L4"
  double along = 0.0;    // mm from its landmark along the line through the landmarks, positive towards the head
  double midline = 0.0;  // mm from that line
};

// Empty for a case without such landmarks. `place`: LPS mm. With a single landmark the line is the body's axis.
std::optional<SkinPlace> skin_place(const Vec3& place, const anatomy::CaseDescription& description);

// "L3/L4" of "L3_L4".
std::string spoken_level(std::string level);

}  // namespace bodkin::training
