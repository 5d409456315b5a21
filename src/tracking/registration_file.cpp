#include "tracking/registration_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "tracking/json_fields.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/placement_file.h"
#include "io/resources.h"

namespace bodkin::tracking {

namespace {

constexpr std::size_t most_bytes = std::size_t{16} << 20U;
constexpr double most_mm = 1e6;

nlohmann::json errors_json(const PlacementErrors& errors) {
  std::vector<double> entries;  // the matrix is symmetric
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 7; ++column) entries.push_back(errors.covariance(row, column));
  return {{"middle_mm", json_of(errors.middle)}, {"covariance", entries}, {"freedom", errors.freedom}};
}

PlacementErrors errors_of(const JsonFields& fields) {
  PlacementErrors errors;
  errors.middle = fields.point("middle_mm");
  errors.freedom = fields.number("freedom", 1e-3, 1e6);
  const auto entries = fields.object.find("covariance");
  Matrix7 matrix = Matrix7::Constant(NAN);
  if (entries != fields.object.end() && entries->is_array() && entries->size() == 49) {
    for (std::size_t i = 0; i < entries->size(); ++i) {
      const nlohmann::json& each = (*entries)[i];
      if (each.is_number()) matrix(static_cast<int>(i / 7), static_cast<int>(i % 7)) = each.get<double>();
    }
  }
  const double largest = matrix.allFinite() ? matrix.cwiseAbs().maxCoeff() : 0.0;
  if (!matrix.allFinite() || matrix.diagonal().minCoeff() < 0.0 ||
      (matrix - matrix.transpose()).cwiseAbs().maxCoeff() > 1e-6 * largest) {
    throw InputError(
        fmt::format("{}: \"covariance\" is not valid, expected 49 numbers, a symmetric 7 x 7 matrix row by row, as "
                    "'bodkin register -o' "
                    "writes it",
                    fields.where));
  }
  errors.covariance = matrix;
  return errors;
}

bool number_in(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  while (end != nullptr && (*end == ' ' || *end == '\r')) ++end;
  return end != text.c_str() && *end == '\0' && std::isfinite(value);
}

}  // namespace

NamedPoints read_points(const std::filesystem::path& file) {
  std::istringstream text(io::read_text_file(file, most_bytes));
  NamedPoints read;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    Vec3 point = Vec3::Zero(), deviation = Vec3::Zero();
    const bool named = cells.size() == 4 || cells.size() == 7, deviates = cells.size() >= 6;
    const std::size_t first = named ? 1 : 0;
    bool good = cells.size() == 3 || cells.size() == 4 || cells.size() == 6 || cells.size() == 7;
    for (std::size_t i = 0; good && i < 3; ++i) good = number_in(cells[first + i], point[static_cast<int>(i)]);
    for (std::size_t i = 0; good && deviates && i < 3; ++i) {
      double& value = deviation[static_cast<int>(i)];
      good = number_in(cells[first + 3 + i], value) && value > 0.0;
    }
    if (!good) {
      if (read.points.empty() && number == 1) continue;  // names of columns
      throw InputError(
          fmt::format("{}, line {}: expected name,x,y,z or x,y,z in mm, with or without three standard deviations "
                      "above 0, found '{}'",
                      file.string(), number, line));
    }
    if (named && std::find(read.names.begin(), read.names.end(), cells[0]) != read.names.end()) {
      throw InputError(fmt::format("{}, line {}: there is a point called '{}' already; give each a name of its own",
                                   file.string(), number, cells[0]));
    }
    if (named) read.names.push_back(cells[0]);
    if (deviates) read.deviations.push_back(deviation);
    read.points.push_back(point);
  }
  if (!read.names.empty() && read.names.size() != read.points.size()) {
    throw InputError(fmt::format("{}: some points have a name and some have none", file.string()));
  }
  if (!read.deviations.empty() && read.deviations.size() != read.points.size()) {
    throw InputError(fmt::format("{}: some points have standard deviations and some have none", file.string()));
  }
  return read;
}

std::string registration_json(const Registration& registration) {
  const Similarity& placed = registration.fixed_from_moving;
  Pose pose = Pose::Identity();
  pose.linear() = placed.turn;
  pose.translation() = placed.shift;
  nlohmann::ordered_json json;
  json["fixed_from_moving"] = json_of(pose);
  json["scale"] = placed.scale;
  json["fre_rms_mm"] = registration.fre_rms;
  json["fre_mean_mm"] = registration.fre_mean;
  json["residuals_mm"] = registration.residuals;
  json["leave_one_out_mm"] = registration.leave_one_out;
  if (registration.errors) json["errors"] = errors_json(*registration.errors);
  if (registration.at_target) {
    const ErrorInterval& tre = registration.at_target->tre;
    json["target_mm"] = json_of(registration.at_target->target);
    json["tre_mm"] = {{"low", tre.low}, {"estimate", tre.estimate}, {"high", tre.high}};
  }
  return json.dump(2) + "\n";
}

Registration read_registration(const std::filesystem::path& file) {
  const nlohmann::json json = read_json_object(file, "registration");
  const JsonFields fields{json, file.string()};
  fields.know({"fixed_from_moving", "scale", "fre_rms_mm", "fre_mean_mm", "residuals_mm", "leave_one_out_mm",
               "target_mm", "tre_mm", "errors"});
  const io::Placement placement = io::read_placement(file);
  Registration read;
  read.fixed_from_moving = {placement.pose.linear(), placement.pose.translation(), placement.scale};
  read.fre_rms = placement.fre_rms;
  read.fre_mean = fields.number("fre_mean_mm", 0.0, most_mm, 0.0);
  if (const auto errors = json.find("errors"); errors != json.end())
    read.errors = errors_of({*errors, file.string() + ": \"errors\""});
  if (const auto tre = json.find("tre_mm"); tre != json.end()) {
    const JsonFields interval{*tre, file.string() + ": \"tre_mm\""};
    TargetError& at_target = read.at_target.emplace();
    at_target.target = fields.point("target_mm");
    at_target.tre = {.low = interval.number("low", 0.0, most_mm),
                     .estimate = interval.number("estimate", 0.0, most_mm),
                     .high = interval.number("high", 0.0, most_mm)};
  }
  return read;
}

}  // namespace bodkin::tracking
