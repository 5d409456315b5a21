#pragma once

#include <vector>

#include "patient/whole_body/body_shape.h"

namespace bodkin::patient {

// Goes on from the last place of `line` (LPS mm, on the skin) to `to` along the skin: always straight at `to` as far
// as the skin allows, in steps of about 5 mm. Nearly the shortest way on limbs and trunk.
void append_skin_line(const BodyShape& shape, const Vec3& to, std::vector<Vec3>& line);

}  // namespace bodkin::patient
