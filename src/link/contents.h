#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "link/bytes.h"

#include "anatomy/grid.h"
#include "core/geometry.h"

// The contents of the kinds of message (OpenIGTLink's protocol, header version 1). Coordinates on the network are RAS
// in mm, those of Bodkin LPS in mm; every function here takes and returns LPS and converts.
namespace bodkin::link {

// The pose of a tool in the patient, whose axes are converted from LPS to RAS or back: L M with L = diag(-1, -1, 1).
// The tool keeps its own axes: a probe's first axis points to its orientation marker in both.
Pose turn_axes(const Pose& pose);

// TRANSFORM: the upper three rows, column by column, in single precision.
Bytes transform_content(const Pose& lps);
Pose read_transform(std::span<const std::uint8_t> content);

// STRING, in ASCII; text beyond 65,535 bytes is truncated.
Bytes string_content(const std::string& text);
std::string read_string(std::span<const std::uint8_t> content);

// STATUS, with the protocol's codes.
inline constexpr std::uint16_t status_ok = 1, status_error = 2, status_busy = 6;
Bytes status_content(std::uint16_t code, const std::string& name, const std::string& message);
struct StatusText {
  std::uint16_t code = 0;
  std::string message;
};
// Throws InputError for fewer bytes than a STATUS has.
StatusText read_status(std::span<const std::uint8_t> content);

// NDARRAY of doubles: `values` row by row, `columns` of them per row; throws InputError if they do not fill rows, or
// for more than 65,535 rows.
Bytes array_content(std::span<const double> values, std::size_t columns);
struct NumberArray {
  std::vector<std::uint16_t> size;  // along each dimension
  std::vector<double> values;
};
NumberArray read_array(std::span<const std::uint8_t> content);

// SENSOR: at most 255 numbers of one unit. Throws InputError for more.
enum class SensorUnit : std::uint8_t { newton, millijoule };
Bytes sensor_content(std::span<const double> values, SensorUnit unit);

// POINT: one named place after another.
struct NamedPoint {
  std::string name, group;                                    // at most 64 and 32 bytes
  std::array<std::uint8_t, 4> colour = {255, 255, 255, 255};  // RGBA
  Vec3 place = Vec3::Zero();                                  // LPS mm
  double radius = 0.0;                                        // mm
  std::string owner;                                          // an image's name, at most 20 bytes
};
Bytes points_content(std::span<const NamedPoint> points);

// POLYDATA with points (LPS mm), triangles and one line through some of them, in that order.
Bytes surface_content(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                      std::span<const int> line);

// The points of a POLYDATA, LPS mm. Throws InputError for fewer bytes than it names and for what is not finite.
std::vector<Vec3> read_surface_points(std::span<const std::uint8_t> content);

// IMAGE of unsigned bytes, `columns` x `rows` x 1 in a row each. `pose`: of the centre of its first pixel, first axis
// along a row, second down the columns, LPS; `pixel` mm.
Bytes image_content(std::span<const std::uint8_t> pixels, int columns, int rows, double pixel, const Pose& pose);

// The part of an IMAGE of signed 16-bit little-endian numbers before its voxels, on that lattice.
Bytes volume_header(const anatomy::Grid& grid);

// IMGMETA: the available images of 16-bit numbers.
struct ListedImage {
  std::string name;      // for people, at most 64 bytes
  std::string device;    // for GET_IMAGE, at most 20 bytes
  std::string modality;  // at most 32 bytes
  std::array<int, 3> size = {0, 0, 0};
};
Bytes image_list_content(std::span<const ListedImage> images);

// Reads an IMAGE of unsigned bytes with one slice. Throws InputError for another kind, for a part of an image, and
// for fewer bytes than stated.
struct GreyImage {
  int width = 0, height = 0;     // pixels
  double pixel = 0.0;            // mm, along a row
  Pose pose = Pose::Identity();  // of the centre of its first pixel, as for image_content()
  std::vector<std::uint8_t> pixels;
};
GreyImage read_image(std::span<const std::uint8_t> content);

// TDATA: one tool after another, each a name of at most 20 bytes and a pose.
struct TrackedTool {
  std::string name;
  Pose pose = Pose::Identity();  // LPS
};
Bytes tracking_content(std::span<const TrackedTool> tools);

}  // namespace bodkin::link
