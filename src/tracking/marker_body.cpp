#include "tracking/marker_body.h"

#include <cmath>
#include <map>
#include <utility>

#include "tracking/json_fields.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr double share_of_marker = 11.0 / 15.0;  // of a face's edge

Pose face_pose(const Vec3& outward, const Vec3& down, double distance) {
  Pose place = Pose::Identity();
  const Vec3 inward = -outward;
  place.linear().col(2) = inward;
  place.linear().col(1) = down;
  place.linear().col(0) = down.cross(inward);
  place.translation() = distance * outward;
  return place;
}

}  // namespace

std::array<Vec3, 4> MarkerFace::corners() const {
  const double half = 0.5 * side;
  return {place * Vec3(-half, -half, 0.0), place * Vec3(half, -half, 0.0), place * Vec3(half, half, 0.0),
          place * Vec3(-half, half, 0.0)};
}

const MarkerFace* MarkerBody::face_of(int id) const {
  for (const MarkerFace& face : faces) {
    if (face.id == id && id >= 0) return &face;
  }
  return nullptr;
}

MarkerBody cube_body(std::string name, int first_id, double edge, double tip) {
  MarkerBody body;
  body.name = std::move(name);
  const Vec3 outward[6] = {-Vec3::UnitZ(), Vec3::UnitX(),  Vec3::UnitY(),
                           -Vec3::UnitX(), -Vec3::UnitY(), Vec3::UnitZ()};
  for (int i = 0; i < 6; ++i) {
    MarkerFace face;
    face.id = i < 5 ? first_id + i : -1;
    face.side = share_of_marker * edge;
    face.sheet = edge;
    face.place = face_pose(outward[i], i == 0 || i == 5 ? Vec3::UnitY() : Vec3::UnitZ(), 0.5 * edge);
    body.faces.push_back(face);
  }
  body.tip = Vec3(0.0, 0.0, tip);
  return body;
}

MarkerBody board_body(std::string name, int first_id, int columns, int rows, double pitch) {
  MarkerBody body;
  body.name = std::move(name);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      MarkerFace face;
      face.id = first_id + row * columns + column;
      face.side = share_of_marker * pitch;
      face.sheet = pitch;
      face.place.translation() = Vec3((column - 0.5 * (columns - 1)) * pitch, (row - 0.5 * (rows - 1)) * pitch, 0.0);
      body.faces.push_back(face);
    }
  }
  return body;
}

std::vector<MarkerBody> station_bodies() {
  return {board_body("mannequin", 0, 4, 3, 52.0), cube_body("needle", 12, 60.0, 150.0),
          cube_body("probe", 17, 60.0, 120.0)};
}

std::vector<MarkerBody> read_bodies(const std::filesystem::path& file) {
  const nlohmann::json json = read_json_object(file, "set of marker bodies");
  const JsonFields root{json, file.string()};
  root.know({"bodies"});
  if (!json.contains("bodies") || !json["bodies"].is_array() || json["bodies"].empty()) {
    throw InputError(fmt::format("{}: \"bodies\" must be a list of at least one body", file.string()));
  }
  std::vector<MarkerBody> bodies;
  std::map<int, std::string> owner;
  for (const nlohmann::json& entry : json["bodies"]) {
    if (!entry.is_object()) throw InputError(fmt::format("{}: a body must be an object", file.string()));
    const std::string name = JsonFields{entry, file.string() + ": a body"}.text("name");
    const JsonFields fields{entry, fmt::format("{}: body \"{}\"", file.string(), name)};
    fields.know({"name", "faces", "tip", "axis"});
    MarkerBody body;
    body.name = name;
    body.tip = fields.point("tip", Vec3::Zero());
    body.axis = fields.point("axis", Vec3::UnitZ());
    if (body.axis.norm() < 1e-6) throw InputError(fields.where + ": \"axis\" has no length");
    body.axis.normalize();
    if (!entry.contains("faces") || !entry["faces"].is_array() || entry["faces"].empty()) {
      throw InputError(fields.where + ": \"faces\" must be a list of at least one face");
    }
    for (const nlohmann::json& part : entry["faces"]) {
      if (!part.is_object()) throw InputError(fields.where + ": a face must be an object");
      const JsonFields of_face{part, fields.where + ": face"};
      of_face.know({"id", "side", "sheet", "place"});
      MarkerFace face;
      face.id = static_cast<int>(of_face.number("id", -1.0, marker_count - 1));
      face.side = of_face.number("side", 1.0, 1000.0);
      face.sheet = of_face.number("sheet", face.side, 2000.0);
      face.place = of_face.pose("place");
      if (face.id >= 0 && !owner.emplace(face.id, name).second) {
        throw InputError(fmt::format("{}: marker {} stands on \"{}\" and on \"{}\"; a marker may be there once",
                                     file.string(), face.id, owner[face.id], name));
      }
      body.faces.push_back(face);
    }
    bodies.push_back(body);
  }
  return bodies;
}

std::string bodies_json(const std::vector<MarkerBody>& bodies) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MarkerBody& body : bodies) {
    nlohmann::ordered_json entry, faces = nlohmann::ordered_json::array();
    for (const MarkerFace& face : body.faces) {
      faces.push_back({{"id", face.id}, {"side", face.side}, {"sheet", face.sheet}, {"place", json_of(face.place)}});
    }
    entry["name"] = body.name;
    entry["tip"] = json_of(body.tip);
    entry["axis"] = json_of(body.axis);
    entry["faces"] = faces;
    list.push_back(entry);
  }
  nlohmann::ordered_json root;
  root["bodies"] = list;
  return root.dump(1) + "\n";
}

}  // namespace bodkin::tracking
