#include "tracking/json_fields.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/resources.h"

namespace bodkin::tracking {

nlohmann::json read_json_object(const std::filesystem::path& file, std::string_view what) {
  constexpr std::size_t most_bytes = std::size_t{256} << 20U;
  nlohmann::json json = nlohmann::json::parse(io::read_text_file(file, most_bytes), nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    throw InputError(fmt::format("{}: not a JSON object that describes a {}", file.string(), what));
  }
  return json;
}

void JsonFields::know(std::initializer_list<std::string_view> names) const {
  for (const auto& [name, value] : object.items()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw InputError(fmt::format("{}: \"{}\" is unknown; there are {}", where, name, fmt::join(names, ", ")));
    }
  }
}

double JsonFields::number(std::string_view name, double low, double high, std::optional<double> otherwise) const {
  const auto found = object.find(std::string(name));
  if (found == object.end() && otherwise) return *otherwise;
  const double value = found != object.end() && found->is_number() ? found->get<double>() : NAN;
  if (!(value >= low && value <= high)) {
    throw InputError(fmt::format("{}: \"{}\" is {}; it must be a number from {} to {}", where, name,
                                 found == object.end() ? "missing" : found->dump(), low, high));
  }
  return value;
}

std::string JsonFields::text(std::string_view name) const {
  const auto found = object.find(std::string(name));
  if (found == object.end() || !found->is_string() || found->get<std::string>().empty()) {
    throw InputError(fmt::format("{}: \"{}\" must be a text", where, name));
  }
  return found->get<std::string>();
}

Vec3 JsonFields::point(std::string_view name, std::optional<Vec3> otherwise) const {
  const auto found = object.find(std::string(name));
  if (found == object.end() && otherwise) return *otherwise;
  Vec3 point = Vec3::Constant(NAN);
  if (found != object.end() && found->is_array() && found->size() == 3) {
    for (int i = 0; i < 3; ++i) {
      const nlohmann::json& part = (*found)[static_cast<std::size_t>(i)];
      if (part.is_number()) point[i] = part.get<double>();
    }
  }
  if (!point.allFinite()) throw InputError(fmt::format("{}: \"{}\" must be three numbers, mm", where, name));
  return point;
}

Pose JsonFields::pose(std::string_view name) const {
  const auto found = object.find(std::string(name));
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Constant(NAN);
  if (found != object.end() && found->is_array() && found->size() == 16) {
    for (std::size_t i = 0; i < 16; ++i) {
      if ((*found)[i].is_number())
        matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = (*found)[i].get<double>();
    }
  }
  const Mat3 turn = matrix.topLeftCorner<3, 3>();
  if (!matrix.allFinite() || !(turn.transpose() * turn).isIdentity(1e-4) || turn.determinant() < 0.0 ||
      !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1))) {
    throw InputError(
        fmt::format("{}: \"{}\" must be 16 numbers, a rigid 4 x 4 matrix row by row in mm", where, name));
  }
  Pose pose;
  pose.matrix() = matrix;
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  return pose;
}

nlohmann::json json_of(const Vec3& point) {
  return nlohmann::json::array({point.x(), point.y(), point.z()});
}

nlohmann::json json_of(const Pose& pose) {
  nlohmann::json numbers = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(pose.matrix()(i / 4, i % 4));
  return numbers;
}

}  // namespace bodkin::tracking
