#include "tracking/camera_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracking/json_fields.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/resources.h"

namespace bodkin::tracking {

namespace {

Eigen::Vector2d distorted(const CameraModel& c, const Eigen::Vector2d& at) {
  const double x = at.x(), y = at.y(), r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  return {x * radial + 2.0 * c.p1 * x * y + c.p2 * (r2 + 2.0 * x * x),
          y * radial + c.p1 * (r2 + 2.0 * y * y) + 2.0 * c.p2 * x * y};
}

constexpr std::pair<const char*, std::optional<int> CameraControls::*> control_fields[] = {
    {"focus", &CameraControls::focus},
    {"exposure", &CameraControls::exposure},
    {"gain", &CameraControls::gain},
    {"white_balance", &CameraControls::white_balance},
    {"sharpness", &CameraControls::sharpness}};

}  // namespace

double ToneCurve::level(double light) const {
  const double x = std::clamp(light, 0.0, 1.0);
  double level = 0.0;
  if (exponent <= 0.0) {
    level = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  } else {
    level = std::pow(x, 1.0 / exponent);
  }
  return level + contrast * (level * level * (3.0 - 2.0 * level) - level);
}

double ToneCurve::light(double level_wanted) const {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (level(middle) < level_wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::array<float, 256> ToneCurve::light_of_bytes() const {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < 256; ++i) table[i] = static_cast<float>(light(static_cast<double>(i) / 255.0));
  return table;
}

Eigen::Vector2d CameraModel::project(const Vec3& point) const {
  const Eigen::Vector2d at = distorted(*this, {point.x() / point.z(), point.y() / point.z()});
  return {fx * at.x() + cx, fy * at.y() + cy};
}

Vec3 CameraModel::ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d seen((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  Eigen::Vector2d at = seen;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector2d step = seen - distorted(*this, at);
    at += step;
    if (step.squaredNorm() < 1e-22) break;
  }
  return {at.x(), at.y(), 1.0};
}

CameraModel footage_camera(int width, int height) {
  CameraModel camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 0.5 * width / std::tan(0.5 * 65.0 * degree);
  camera.cx = 0.5 * (width - 1) + 0.01 * width;
  camera.cy = 0.5 * (height - 1) - 0.01 * height;
  camera.k1 = -0.12;
  camera.k2 = 0.06;
  camera.p1 = 0.0005;
  camera.p2 = -0.0004;
  return camera;
}

std::vector<Eigen::Vector2f> ray_table(const CameraModel& camera) {
  std::vector<Eigen::Vector2f> rays;
  rays.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray({x, y}).head<2>().cast<float>());
  }
  return rays;
}

CameraModel read_camera(const std::filesystem::path& file) {
  const nlohmann::json json = read_json_object(file, "camera");
  const JsonFields fields{json, file.string() + ": camera"};
  fields.know({"width", "height", "fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "tone_exponent",
               "tone_contrast", "blur", "residual", "controls"});
  CameraModel camera;
  camera.width = static_cast<int>(fields.number("width", 16.0, 16384.0));
  camera.height = static_cast<int>(fields.number("height", 16.0, 16384.0));
  const double most = 100.0 * camera.width;
  camera.fx = fields.number("fx", 1.0, most);
  camera.fy = fields.number("fy", 1.0, most);
  camera.cx = fields.number("cx", -camera.width, 2.0 * camera.width);
  camera.cy = fields.number("cy", -camera.height, 2.0 * camera.height);
  camera.k1 = fields.number("k1", -5.0, 5.0, 0.0);
  camera.k2 = fields.number("k2", -5.0, 5.0, 0.0);
  camera.p1 = fields.number("p1", -1.0, 1.0, 0.0);
  camera.p2 = fields.number("p2", -1.0, 1.0, 0.0);
  camera.k3 = fields.number("k3", -5.0, 5.0, 0.0);
  camera.tone.exponent = fields.number("tone_exponent", 0.0, 3.0, 0.0);
  camera.tone.contrast = fields.number("tone_contrast", 0.0, 1.0, 0.0);
  if (camera.tone.exponent > 0.0 && camera.tone.exponent < 1.0) {
    throw InputError(fmt::format("{}: camera: \"tone_exponent\" is {}; it is 0 (sRGB) or 1 to 3", file.string(),
                                 camera.tone.exponent));
  }
  camera.blur = fields.number("blur", 0.2, 10.0, 0.7);
  camera.residual = fields.number("residual", 0.0, 1000.0, 0.0);
  if (json.contains("controls")) {
    const nlohmann::json& entry = json["controls"];
    const JsonFields controls{entry, fields.where + ": controls"};
    if (!entry.is_object()) throw InputError(controls.where + " must be an object");
    controls.know({"focus", "exposure", "gain", "white_balance", "sharpness"});
    for (const auto& [name, field] : control_fields) {
      if (entry.contains(name)) camera.controls.*field = static_cast<int>(controls.number(name, -1e9, 1e9));
    }
  }
  return camera;
}

std::string camera_json(const CameraModel& camera) {
  nlohmann::ordered_json json;
  json["width"] = camera.width;
  json["height"] = camera.height;
  json["fx"] = camera.fx;
  json["fy"] = camera.fy;
  json["cx"] = camera.cx;
  json["cy"] = camera.cy;
  json["k1"] = camera.k1;
  json["k2"] = camera.k2;
  json["p1"] = camera.p1;
  json["p2"] = camera.p2;
  json["k3"] = camera.k3;
  json["tone_exponent"] = camera.tone.exponent;
  json["tone_contrast"] = camera.tone.contrast;
  json["blur"] = camera.blur;
  json["residual"] = camera.residual;
  nlohmann::ordered_json controls;
  for (const auto& [name, field] : control_fields) {
    if (camera.controls.*field) controls[name] = *(camera.controls.*field);
  }
  if (!controls.empty()) json["controls"] = controls;
  return json.dump(2) + "\n";
}

}  // namespace bodkin::tracking
