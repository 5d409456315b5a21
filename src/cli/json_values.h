#pragma once

#include <nlohmann/json.hpp>

#include "core/geometry.h"

namespace bodkin {

inline nlohmann::json json_point(const Vec3& point) {
  return {point.x(), point.y(), point.z()};
}

}  // namespace bodkin
