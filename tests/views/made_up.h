#pragma once

#include <memory>

#include "views/changes.h"
#include "views/frame.h"
#include "views/open_case.h"

namespace bodkin_test {

// Depths of the layers under the skin of layered_patient(), mm.
inline constexpr double skin_to = 2.0, fat_to = 12.0, muscle_to = 30.0, flavum_to = 34.0, fluid_to = 50.0;

// A block of 100 mm with a skin at y = 30 mm, air behind it, and layers of skin, fat, muscle, ligamentum flavum and
// fluid with increasing depth (towards negative y). The HU rise linearly: 40 + 2 x + 5 z, in all tissues. The planned
// path leads straight in from (0, 30, 0) to a depth of 40 mm. A vessel of 8 mm runs along x at y = -25, z = 20.
std::shared_ptr<const bodkin::views::OpenCase> layered_patient();

double layered_hounsfield(const bodkin::Vec3& point);

// The needle at a depth on the planned path (negative: above the skin), and everything that follows from it.
bodkin::views::Frame frame_at(double depth);

}  // namespace bodkin_test
