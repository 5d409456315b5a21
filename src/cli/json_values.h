#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/geometry.h"

namespace bodkin::cli {

// [x, y, z]
nlohmann::json json_point(const Vec3& point);

}  // namespace bodkin::cli
