#pragma once

#include <vector>

#include "patient/whole_body/body_shape.h"

namespace bodkin::patient {

// Extends `line` from its last point (LPS mm, on the skin) to `to` along the skin: always straight towards `to` as
// far as the skin allows, in steps of about 5 mm. Nearly the shortest path on limbs and trunk.
void append_skin_line(const BodyShape& shape, const Vec3& to, std::vector<Vec3>& line);

}  // namespace bodkin::patient
