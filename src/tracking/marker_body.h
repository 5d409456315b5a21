#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"

namespace bodkin::tracking {

// Markers are those of OpenCV's dictionary DICT_4X4_50: 6 x 6 cells, of which the outer ones are black.
inline constexpr int marker_cells = 6;
inline constexpr int marker_count = 50;

// Whether each cell of a marker is white, row by row from the upper left one. `id`: 0 to 49.
std::array<std::array<bool, marker_cells>, marker_cells> marker_pattern(int id);

// A flat white sheet with one marker in its middle. Its frame: origin in the middle of the marker, x to the right and
// y down as one looks at the marker, z into the body.
struct MarkerFace {
  int id = -1;                    // of the marker; -1: a plain sheet, which only hides the objects behind it
  double side = 0.0;              // of the black square, mm
  double sheet = 0.0;             // edge of the white sheet, mm
  Pose place = Pose::Identity();  // face frame to body frame
  double reflectance = 0.45;      // of a plain sheet, fraction of white; used only for drawing

  // Upper left, upper right, lower right, lower left corner of the black square, body frame.
  std::array<Vec3, 4> corners() const;
};

// A rigid body that carries markers: the board of a mannequin, a cube on a needle's hub or on a dummy probe.
struct MarkerBody {
  std::string name;
  std::vector<MarkerFace> faces;
  Vec3 tip = Vec3::Zero();    // reference point: the tip of the needle, the middle of the probe's face; mm
  Vec3 axis = Vec3::UnitZ();  // from hub to tip, from the probe into the patient; unit

  const MarkerFace* face_of(int id) const;
};

// A cube with the markers `first_id` to `first_id` + 4 on five faces; a needle or a probe is attached to the sixth,
// +z. `edge`: mm; the marker takes 11/15 of it, leaving a margin of one cell. `tip`: mm along z.
MarkerBody cube_body(std::string name, int first_id, double edge, double tip);
// A flat board of `columns` x `rows` markers with `pitch` mm from one to the next; x to the right, y down, z away
// from the viewer, origin in the middle.
MarkerBody board_body(std::string name, int first_id, int columns, int rows, double pitch);

// The bodies of a teaching station: the mannequin's board (markers 0 to 11), the needle (12 to 16) and the probe
// (17 to 21).
std::vector<MarkerBody> station_bodies();

// Bodies as a JSON file. Reading throws InputError that names file, body and field; two faces with one number are
// rejected.
std::vector<MarkerBody> read_bodies(const std::filesystem::path& file);
std::string bodies_json(const std::vector<MarkerBody>& bodies);

}  // namespace bodkin::tracking
