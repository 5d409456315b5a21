#include "cli/json_values.h"

#include <nlohmann/json.hpp>

namespace bodkin::cli {

nlohmann::json json_point(const Vec3& point) {
  return {point.x(), point.y(), point.z()};
}

}  // namespace bodkin::cli
