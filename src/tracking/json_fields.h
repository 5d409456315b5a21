#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/geometry.h"

namespace bodkin::tracking {

// The JSON object in a file that contains a `what`. Throws InputError when there is none.
nlohmann::json read_json_object(const std::filesystem::path& file, std::string_view what);

// The fields of a JSON object. Each function throws InputError, beginning with `where` ("bodies.json: body
// \"needle\""), when a field is absent (and has no default) or is invalid.
struct JsonFields {
  const nlohmann::json& object;
  std::string where;

  // Rejects fields other than these.
  void know(std::initializer_list<std::string_view> names) const;
  double number(std::string_view name, double low, double high, std::optional<double> otherwise = std::nullopt) const;
  std::string text(std::string_view name) const;
  // Three numbers, mm.
  Vec3 point(std::string_view name, std::optional<Vec3> otherwise = std::nullopt) const;
  // 16 numbers, a 4 x 4 matrix row by row: rotation and translation in mm.
  Pose pose(std::string_view name) const;
};

nlohmann::json json_of(const Vec3& point);
nlohmann::json json_of(const Pose& pose);

}  // namespace bodkin::tracking
