#include "tracking/footage_scene.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "tracking/jpeg_file.h"
#include "tracking/json_fields.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"
#include "core/random.h"
#include "core/shortest_turn.h"
#include "imaging/png_file.h"
#include "io/resources.h"

namespace bodkin::tracking {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_picture_bytes = std::size_t{256} << 20U;

// A pose whose third axis is `axis`, turned about it.
Pose pointing(const Vec3& origin, const Vec3& axis, double turned) {
  Pose pose = Pose::Identity();
  pose.linear() =
      (shortest_turn(Vec3::UnitZ(), axis.normalized()) * Eigen::AngleAxisd(turned, Vec3::UnitZ())).toRotationMatrix();
  pose.translation() = origin;
  return pose;
}

constexpr double above_skin = 40.0;                          // mm, where a needle that follows a path begins
constexpr double tip_speed = 15.0;                           // mm/s
constexpr double pause_before = 0.5, pause_at_target = 1.5;  // s at rest above the skin, and at the end of the path

// Depth below the skin of a needle on a path, mm.
double depth_at(double time, double path) {
  const double arrives = pause_before + (above_skin + path) / tip_speed;
  const double going = std::clamp(tip_speed * (time - pause_before), 0.0, above_skin + path);
  const double leaving = std::clamp(2.0 * tip_speed * (time - arrives - pause_at_target), 0.0, above_skin + path);
  return going - leaving - above_skin;
}

std::vector<Pose> places_at(double time, const SceneOptions& options, const std::vector<MarkerBody>& bodies) {
  Random random(options.seed);
  const double tilt = random.uniform(0.35, 0.5), turned = random.uniform(-0.06, 0.06);
  const double swing = options.still ? 0.0 : 1.0;
  Pose mannequin = Pose::Identity();
  mannequin.translation() = Vec3(175.0 + 4.0 * swing * std::sin(0.7 * time), 10.0, 720.0);
  mannequin.linear() = (Eigen::AngleAxisd(tilt, Vec3(1.0, 0.35, 0.0).normalized()) *
                        Eigen::AngleAxisd(turned + 0.02 * swing * std::sin(0.5 * time), Vec3::UnitZ()))
                           .toRotationMatrix();
  // The needle moves in and out by 30 mm about a depth of 30 mm, and its hub turns.
  const double depth = options.path > 0.0 ? depth_at(time, options.path)
                                          : 30.0 - 30.0 * std::cos(1.2 * swing * time + (options.still ? 1.5 : 0.0));
  const Vec3 axis =
      options.path > 0.0 ? Vec3::UnitZ() : Vec3(0.28, 0.42 + 0.04 * swing * std::sin(0.9 * time), 0.86).normalized();
  const Vec3 entry = scene_skin() + (options.path > 0.0 ? Vec3(options.aside, 0.0, 0.0) : Vec3(10.0, -15.0, 0.0));
  const Vec3 tip = entry + depth * axis;
  const Pose needle =
      mannequin * pointing(tip - axis * bodies[1].tip.norm(), axis, 0.5 + 0.6 * swing * std::sin(0.4 * time));
  const Vec3 probe_axis = Vec3(0.15, -0.45, 0.88).normalized();
  const Vec3 face = scene_skin() + Vec3(-35.0 + 12.0 * swing * std::sin(0.8 * time), 60.0, 0.0);
  const Pose probe = mannequin * pointing(face - probe_axis * bodies[2].tip.norm(), probe_axis, 0.3);
  return {mannequin, needle, probe};
}

}  // namespace

double motion_duration(const SceneOptions& options) {
  const double advance = (above_skin + options.path) / tip_speed;
  return pause_before + advance + pause_at_target + 0.5 * advance + pause_before;
}

Vec3 scene_skin() {
  return {-235.0, 0.0, 6.0};
}

imaging::ImageRgb read_picture(const fs::path& file) {
  const std::string bytes = io::read_text_file(file, most_picture_bytes);
  std::string kind = file.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kind == ".png" ? imaging::decode_png(bytes, file.string()) : decode_jpeg(bytes, file.string());
}

Footage render_scene(const fs::path& folder, const SceneOptions& options, const Progress& progress) {
  std::error_code code;
  if (fs::exists(folder, code) && !fs::is_empty(folder, code)) {
    throw InputError(fmt::format("{}: the folder is not empty; name a new one", folder.string()));
  }
  CameraModel camera = footage_camera(options.width, options.height);
  camera.tone = options.tone;
  camera.blur = options.blur;
  const std::vector<MarkerBody> bodies = station_bodies();
  // The mannequin's back, without markers.
  MarkerBody torso;
  MarkerFace skin;
  skin.side = skin.sheet = 250.0;
  skin.place.translation() = scene_skin();
  torso.faces.push_back(skin);

  FootageLook look = options.look;
  if (options.motion > 0.0) {
    look.instants = 8;
    look.samples = std::min(look.samples, 3);
  }
  Footage footage;
  footage.folder = folder;
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();
  for (const MarkerBody& body : bodies) footage.bodies.push_back(body.name);
  for (int n = 0; n < options.frames; ++n) {
    if (progress) progress("footage", static_cast<double>(n) / options.frames);
    FootageFrame frame;
    frame.time = n / options.rate;
    frame.file = fmt::format("frame_{:05}.png", n);
    frame.camera_from_body = places_at(frame.time, options, bodies);
    std::vector<PlacedBody> placed;
    for (std::size_t i = 0; i < bodies.size(); ++i) placed.push_back({&bodies[i], frame.camera_from_body[i]});
    placed.push_back({&torso, frame.camera_from_body[0]});
    if (options.motion > 0.0) {
      const double across = options.motion * frame.camera_from_body[1].translation().z() / camera.fx;
      placed[1].shift = across * Vec3(0.8, 0.6, 0.0);
    }
    const std::uint64_t seed = options.seed * 1000003U + static_cast<std::uint64_t>(n);
    const GreyImage picture = render_picture(camera, look, placed, seed);
    write_file(folder / frame.file, imaging::encode_png(colour_of(picture)));
    nlohmann::ordered_json poses;
    for (std::size_t i = 0; i < bodies.size(); ++i) poses[bodies[i].name] = json_of(frame.camera_from_body[i]);
    frames.push_back({{"file", frame.file}, {"time", frame.time}, {"camera_from_body", poses}});
    footage.frames.push_back(frame);
  }
  write_file(folder / "camera.json", camera_json(camera));
  write_file(folder / "bodies.json", bodies_json(bodies));
  nlohmann::ordered_json scene;
  scene["frames"] = frames;
  write_file(folder / "scene.json", scene.dump(1) + "\n");
  if (progress) progress("footage", 1.0);
  return footage;
}

Footage open_footage(const fs::path& folder, double rate) {
  std::error_code code;
  if (!fs::is_directory(folder, code)) {
    throw InputError(fmt::format(
        "{}: no such folder; expected a folder of pictures, such as 'bodkin scene render' makes", folder.string()));
  }
  Footage footage;
  footage.folder = folder;
  if (fs::exists(folder / "scene.json", code)) {
    const std::string where = (folder / "scene.json").string();
    const nlohmann::json json = read_json_object(folder / "scene.json", "scene");
    if (!json.contains("frames") || !json["frames"].is_array() || json["frames"].empty()) {
      throw InputError(where + ": \"frames\" must be a list of at least one picture");
    }
    for (const nlohmann::json& entry : json["frames"]) {
      const JsonFields fields{entry, where + ": frame " + std::to_string(footage.frames.size())};
      if (!entry.is_object() || !entry.contains("camera_from_body") || !entry["camera_from_body"].is_object()) {
        throw InputError(fields.where + ": \"camera_from_body\" is missing");
      }
      FootageFrame frame;
      frame.file = io::file_inside(folder, fields.text("file"), fields.where).filename().string();
      frame.time = fields.number("time", 0.0, 1e9);
      std::vector<std::string> names;
      const JsonFields poses{entry["camera_from_body"], fields.where};
      for (const auto& [name, matrix] : entry["camera_from_body"].items()) {
        names.push_back(name);
        frame.camera_from_body.push_back(poses.pose(name));
      }
      if (footage.frames.empty()) footage.bodies = names;
      if (names != footage.bodies)
        throw InputError(fields.where + ": its bodies differ from those of the first frame");
      footage.frames.push_back(frame);
    }
    return footage;
  }
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::string kind = entry.path().extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (kind == ".png" || kind == ".jpg" || kind == ".jpeg") names.push_back(entry.path().filename().string());
  }
  if (names.empty()) throw InputError(fmt::format("{}: no pictures (.png, .jpg) in this folder", folder.string()));
  std::sort(names.begin(), names.end());
  for (std::size_t i = 0; i < names.size(); ++i)
    footage.frames.push_back({names[i], static_cast<double>(i) / rate, {}});
  return footage;
}

}  // namespace bodkin::tracking
