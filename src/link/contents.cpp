#include "link/contents.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

namespace {

constexpr std::uint16_t us_ascii = 3;  // of the IANA's numbers of character sets
constexpr std::uint8_t float64 = 11;   // scalar types of NDARRAY and IMAGE
constexpr std::uint8_t uint8 = 3, int16 = 4;
constexpr std::uint8_t six_degrees = 2;  // of a tool of TDATA
constexpr std::size_t most_values = 1 << 22;

Vec3 turned(const Vec3& point) {
  return {-point.x(), -point.y(), point.z()};
}

void put_matrix(ByteWriter& writer, const Pose& ras) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) writer.f32(static_cast<float>(ras.matrix()(row, column)));
}

void put_point(ByteWriter& writer, const Vec3& lps) {
  const Vec3 ras = turned(lps);
  for (int axis = 0; axis < 3; ++axis) writer.f32(static_cast<float>(ras[axis]));
}

// Of an image with one number per voxel. Its position is its middle, not its corner.
void put_image_header(ByteWriter& writer, std::uint8_t type, std::uint8_t byte_order, const anatomy::Grid& grid) {
  constexpr std::uint16_t image_version = 1;
  constexpr std::uint8_t right_anterior_superior = 1;
  writer.u16(image_version);
  writer.u8(1);  // numbers per voxel
  writer.u8(type);
  writer.u8(byte_order);
  writer.u8(right_anterior_superior);
  for (const int count : grid.size) writer.u16(static_cast<std::uint16_t>(count));
  for (int axis = 0; axis < 3; ++axis) put_point(writer, grid.spacing[axis] * grid.direction.col(axis));
  put_point(writer, grid.to_patient(0.5 * Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1)));
  for (int axis = 0; axis < 3; ++axis) writer.u16(0);  // the whole image, not a part
  for (const int count : grid.size) writer.u16(static_cast<std::uint16_t>(count));
}

}  // namespace

Pose turn_axes(const Pose& pose) {
  const Vec3 signs(-1.0, -1.0, 1.0);
  Pose result = Pose::Identity();
  result.linear() = signs.asDiagonal() * pose.linear();
  result.translation() = signs.cwiseProduct(pose.translation());
  return result;
}

Bytes transform_content(const Pose& lps) {
  ByteWriter writer;
  put_matrix(writer, turn_axes(lps));
  return writer.take();
}

Pose read_transform(std::span<const std::uint8_t> content) {
  ByteReader reader(content);
  Pose ras = Pose::Identity();
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) ras.matrix()(row, column) = static_cast<double>(reader.f32());
  if (!ras.matrix().allFinite()) throw InputError("a transform holds something that is not a finite number");
  return turn_axes(ras);
}

Bytes string_content(const std::string& text) {
  const std::size_t size = std::min<std::size_t>(text.size(), std::numeric_limits<std::uint16_t>::max());
  ByteWriter writer;
  writer.u16(us_ascii);
  writer.u16(static_cast<std::uint16_t>(size));
  writer.field(text, size);
  return writer.take();
}

std::string read_string(std::span<const std::uint8_t> content) {
  ByteReader reader(content);
  reader.u16();  // the character set: ASCII and UTF-8 are sent
  const std::span<const std::uint8_t> text = reader.raw(reader.u16());
  return {text.begin(), text.end()};
}

Bytes status_content(std::uint16_t code, const std::string& name, const std::string& message) {
  constexpr std::size_t name_size = 20;
  ByteWriter writer;
  writer.u16(code);
  writer.u64(0);
  writer.field(name, name_size);
  writer.field(message, message.size() + 1);  // ends with a zero
  return writer.take();
}

StatusText read_status(std::span<const std::uint8_t> content) {
  constexpr std::size_t sub_code = 8, name_size = 20;
  ByteReader reader(content);
  StatusText status{.code = reader.u16(), .message = {}};
  reader.raw(sub_code);
  reader.raw(name_size);
  status.message = reader.field(reader.left());
  return status;
}

Bytes sensor_content(std::span<const double> values, SensorUnit unit) {
  constexpr std::size_t most = std::numeric_limits<std::uint8_t>::max();
  if (values.size() > most)
    throw InputError(fmt::format("{} numbers, but a SENSOR holds at most {}", values.size(), most));
  // Four bits of a prefix, then six units of six bits, each with an exponent of four.
  constexpr std::uint64_t milli = 0xB, newton = 0x0B, joule = 0x0D, once = 1;
  const auto packed = [](std::uint64_t prefix, std::uint64_t of) { return prefix << 60U | of << 54U | once << 50U; };
  ByteWriter writer;
  writer.u8(static_cast<std::uint8_t>(values.size()));
  writer.u8(0);  // reserved
  writer.u64(unit == SensorUnit::newton ? packed(0, newton) : packed(milli, joule));
  for (const double value : values) writer.f64(value);
  return writer.take();
}

Bytes array_content(std::span<const double> values, std::size_t columns) {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  if (columns == 0 || columns > most || values.size() % columns != 0 || values.size() / columns > most) {
    throw InputError(fmt::format("{} numbers are no array with rows of {}, expected whole rows, at most {} of them",
                                 values.size(), columns, most));
  }
  ByteWriter writer;
  writer.u8(float64);
  writer.u8(2);
  writer.u16(static_cast<std::uint16_t>(values.size() / columns));
  writer.u16(static_cast<std::uint16_t>(columns));
  for (const double value : values) writer.f64(value);
  return writer.take();
}

NumberArray read_array(std::span<const std::uint8_t> content) {
  ByteReader reader(content);
  if (const int type = reader.u8(); type != float64)
    throw InputError(fmt::format("an array has numbers of type {}, expected {}, doubles", type, float64));
  NumberArray array;
  std::size_t count = 1;
  const int dimensions = reader.u8();
  for (int i = 0; i < dimensions; ++i) {
    array.size.push_back(reader.u16());
    count *= array.size.back();
    if (count > most_values) throw InputError(fmt::format("an array has more than {} numbers", most_values));
  }
  if (count * sizeof(double) > reader.left())
    throw InputError(fmt::format("an array of {} numbers comes with {} bytes", count, reader.left()));
  array.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) array.values.push_back(reader.f64());
  return array;
}

Bytes points_content(std::span<const NamedPoint> points) {
  ByteWriter writer;
  for (const NamedPoint& point : points) {
    writer.field(point.name, 64);
    writer.field(point.group, 32);
    writer.raw(point.colour);
    put_point(writer, point.place);
    writer.f32(static_cast<float>(point.radius));
    writer.field(point.owner, 20);
  }
  return writer.take();
}

Bytes surface_content(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                      std::span<const int> line) {
  constexpr std::size_t word = 4;
  const auto u32 = [](std::size_t value) { return static_cast<std::uint32_t>(value); };
  ByteWriter writer;
  writer.u32(u32(points.size()));
  writer.u32(0);  // vertices, and their size in bytes
  writer.u32(0);
  writer.u32(line.empty() ? 0 : 1);
  writer.u32(line.empty() ? 0 : u32(word * (line.size() + 1)));
  writer.u32(u32(triangles.size()));
  writer.u32(u32(4 * word * triangles.size()));
  writer.u32(0);  // strips of triangles, and their size
  writer.u32(0);
  writer.u32(0);  // attributes
  for (const Vec3& point : points) put_point(writer, point);
  if (!line.empty()) {
    writer.u32(u32(line.size()));
    for (const int point : line) writer.u32(static_cast<std::uint32_t>(point));
  }
  for (const std::array<int, 3>& triangle : triangles) {
    writer.u32(3);
    for (const int point : triangle) writer.u32(static_cast<std::uint32_t>(point));
  }
  return writer.take();
}

std::vector<Vec3> read_surface_points(std::span<const std::uint8_t> content) {
  constexpr std::size_t other_counts = 9, point_size = 12;
  ByteReader reader(content);
  const std::size_t count = reader.u32();
  for (std::size_t i = 0; i < other_counts; ++i) reader.u32();
  if (count > reader.left() / point_size)
    throw InputError(fmt::format("a surface of {} points comes with {} bytes", count, reader.left()));
  std::vector<Vec3> points(count);
  for (Vec3& point : points) {
    const auto x = static_cast<double>(reader.f32()), y = static_cast<double>(reader.f32());
    point = turned({x, y, static_cast<double>(reader.f32())});
    if (!point.allFinite()) throw InputError("a surface has a point that is not a finite number");
  }
  return points;
}

Bytes image_content(std::span<const std::uint8_t> pixels, int columns, int rows, double pixel, const Pose& pose) {
  constexpr std::uint8_t either_end = 2;
  if (columns < 1 || rows < 1 ||
      pixels.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
    throw InputError(fmt::format("{} pixels do not make an image of {} x {}", pixels.size(), columns, rows));
  }
  const anatomy::Grid grid{{columns, rows, 1}, Vec3::Constant(pixel), pose.linear(), pose.translation()};
  ByteWriter writer;
  put_image_header(writer, uint8, either_end, grid);
  writer.raw(pixels);
  return writer.take();
}

Bytes volume_header(const anatomy::Grid& grid) {
  constexpr std::uint8_t lowest_first = 2;
  for (const int count : grid.size) {
    if (count < 1 || count > std::numeric_limits<std::uint16_t>::max())
      throw InputError(fmt::format("an image has {} voxels along an axis, expected 1 to 65,535", count));
  }
  ByteWriter writer;
  put_image_header(writer, int16, lowest_first, grid);
  return writer.take();
}

Bytes image_list_content(std::span<const ListedImage> images) {
  constexpr std::size_t text = 64, device = 20, modality = 32;
  ByteWriter writer;
  for (const ListedImage& image : images) {
    writer.field(image.name, text);
    writer.field(image.device, device);
    writer.field(image.modality, modality);
    writer.field({}, text);  // of the patient: name
    writer.field({}, text);  // and number
    writer.u64(0);           // time of the scan
    for (const int count : image.size) writer.u16(static_cast<std::uint16_t>(count));
    writer.u8(int16);
    writer.u8(0);
  }
  return writer.take();
}

GreyImage read_image(std::span<const std::uint8_t> content) {
  ByteReader reader(content);
  reader.u16();  // version
  const int components = reader.u8(), type = reader.u8();
  reader.u16();  // byte order, axes
  std::array<int, 3> size{};
  for (int& count : size) count = reader.u16();
  std::array<Vec3, 4> place;  // steps along each axis, and the middle of the picture
  for (Vec3& each : place) {
    const auto x = static_cast<double>(reader.f32()), y = static_cast<double>(reader.f32());
    each = turned({x, y, static_cast<double>(reader.f32())});
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (reader.u16() != 0) throw InputError("an image comes in parts, expected a whole one");
  }
  for (const int count : size) {
    if (reader.u16() != count) throw InputError("an image comes in parts, expected a whole one");
  }
  if (components != 1 || type != uint8 || size[2] != 1 || size[0] < 1 || size[1] < 1) {
    throw InputError(
        fmt::format("an image of {} x {} x {} pixels has {} values of type {} per pixel, expected a slice with one "
                    "byte per pixel",
                    size[0], size[1], size[2], components, type));
  }
  const auto bytes = reader.raw(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  GreyImage image{size[0], size[1], place[0].norm(), Pose::Identity(), {bytes.begin(), bytes.end()}};
  const bool is_placed = place[3].allFinite() && std::isfinite(image.pixel) && image.pixel > 0.0 &&
                         place[1].allFinite() && place[1].norm() > 0.0;
  if (!is_placed) throw InputError("the pixels of an image have no size, or its position is not finite");
  const Vec3 along = place[0].normalized(), down = place[1].normalized(), across = along.cross(down);
  image.pose.linear().col(0) = along;
  image.pose.linear().col(1) = down;
  image.pose.linear().col(2) = across;
  image.pose.translation() =
      place[3] - 0.5 * (size[0] - 1) * image.pixel * along - 0.5 * (size[1] - 1) * image.pixel * down;
  return image;
}

Bytes tracking_content(std::span<const TrackedTool> tools) {
  constexpr std::size_t name_size = 20;
  ByteWriter writer;
  for (const TrackedTool& tool : tools) {
    writer.field(tool.name, name_size);
    writer.u8(six_degrees);
    writer.u8(0);
    put_matrix(writer, turn_axes(tool.pose));
  }
  return writer.take();
}

}  // namespace bodkin::link
