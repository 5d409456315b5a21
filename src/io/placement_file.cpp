#include "io/placement_file.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/resources.h"

namespace bodkin::io {

namespace {

double number_in(const nlohmann::json& json, const std::filesystem::path& file, const char* name, double low,
                 double high, double otherwise) {
  const auto found = json.find(name);
  if (found == json.end()) return otherwise;
  const double value = found->is_number() ? found->get<double>() : NAN;
  if (value >= low && value <= high) return value;
  throw InputError(fmt::format("{}: \"{}\" is {}, expected a number from {:g} to {:g}", file.string(), name,
                               found->dump().substr(0, 40), low, high));
}

}  // namespace

Placement read_placement(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = std::size_t{16} << 20U;
  constexpr std::size_t entries = 16;  // of the matrix, row by row
  const nlohmann::json json = nlohmann::json::parse(read_text_file(file, most_bytes), nullptr, false);
  if (!json.is_object()) {
    throw InputError(fmt::format(
        "{}: this is not a JSON object, expected a registration that 'bodkin register -o' wrote", file.string()));
  }
  const auto matrix = json.find("fixed_from_moving");
  Eigen::Matrix4d numbers = Eigen::Matrix4d::Constant(NAN);
  if (matrix != json.end() && matrix->is_array() && matrix->size() == entries) {
    for (std::size_t i = 0; i < entries; ++i) {
      const nlohmann::json& each = (*matrix)[i];
      if (each.is_number()) numbers(static_cast<int>(i / 4), static_cast<int>(i % 4)) = each.get<double>();
    }
  }
  constexpr double tolerance = 1e-4;
  const Mat3 turn = numbers.topLeftCorner<3, 3>();
  if (!numbers.allFinite() || !(turn.transpose() * turn).isIdentity(tolerance) || turn.determinant() < 0.0 ||
      numbers.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)) {
    throw InputError(
        fmt::format("{}: \"fixed_from_moving\" is not a rigid placement, expected 16 numbers, a 4 x 4 matrix row by "
                    "row in mm, as 'bodkin register -o' writes it",
                    file.string()));
  }
  Placement placement;
  placement.pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  placement.pose.translation() = numbers.topRightCorner<3, 1>();
  placement.scale = number_in(json, file, "scale", 0.1, 10.0, 1.0);
  placement.fre_rms = number_in(json, file, "fre_rms_mm", 0.0, 1e6, 0.0);
  return placement;
}

Pose read_rigid_placement(const std::filesystem::path& file, std::string_view advice) {
  constexpr double tolerance = 0.02;
  const Placement placement = read_placement(file);
  if (std::abs(placement.scale - 1.0) <= tolerance) return placement.pose;
  throw InputError(fmt::format("{}: its scale is {:.4f}, expected 1; {}", file.string(), placement.scale, advice));
}

std::string placement_json(const Placement& placement) {
  nlohmann::ordered_json json;
  nlohmann::ordered_json& matrix = json["fixed_from_moving"] = nlohmann::ordered_json::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix.push_back(placement.pose.matrix()(row, column));
  json["scale"] = placement.scale;
  if (placement.fre_rms > 0.0) json["fre_rms_mm"] = placement.fre_rms;
  return json.dump(2) + "\n";
}

}  // namespace bodkin::io
