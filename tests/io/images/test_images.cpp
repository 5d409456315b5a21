#include "tests/io/images/test_images.h"

#include <array>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <zlib.h>

namespace bodkin::test {

using namespace bodkin::anatomy;
namespace {

template <typename Number>
void put(std::string& bytes, std::size_t place, Number value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
}

std::string voxel_bytes(const CtVolume& volume) {
  std::string bytes(volume.voxels.size() * sizeof(std::int16_t), '\0');
  std::memcpy(bytes.data(), volume.voxels.data(), bytes.size());
  return bytes;
}

std::string vector_text(const Vec3& v) {
  return fmt::format("({:.17g},{:.17g},{:.17g})", v.x(), v.y(), v.z());
}

}  // namespace

std::string dicom_element(unsigned group, unsigned number, const std::string& vr, std::string value) {
  if (value.size() % 2 == 1) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
  std::string bytes(4, '\0');
  put(bytes, 0, static_cast<std::uint16_t>(group));
  put(bytes, 2, static_cast<std::uint16_t>(number));
  bytes += vr;
  const bool long_form = vr == "OW" || vr == "OB" || vr == "SQ" || vr == "UN";
  if (long_form) {
    bytes.resize(12, '\0');  // after two reserved bytes
    put(bytes, 8, static_cast<std::uint32_t>(value.size()));
  } else {
    bytes.resize(8, '\0');
    put(bytes, 6, static_cast<std::uint16_t>(value.size()));
  }
  bytes += value;
  return bytes;
}

std::string dicom_sequence(unsigned group, unsigned number, const std::vector<std::string>& items) {
  std::string value;
  for (const std::string& item : items) {
    std::string head("\xFE\xFF\x00\xE0\0\0\0\0", 8);
    put(head, 4, static_cast<std::uint32_t>(item.size()));
    value += head + item;
  }
  return dicom_element(group, number, "SQ", value);
}

std::string dicom_number(unsigned value) {
  std::string bytes(2, '\0');
  put(bytes, 0, static_cast<std::uint16_t>(value));
  return bytes;
}

std::string dicom_point(const Vec3& p) {
  return fmt::format("{:.10g}\\{:.10g}\\{:.10g}", p.x(), p.y(), p.z());
}

std::string dicom_file(const std::string& sop_class, const std::string& transfer_syntax, const std::string& instance,
                       const std::string& elements) {
  const std::string meta = dicom_element(2, 1, "OB", std::string("\0\1", 2)) + dicom_element(2, 2, "UI", sop_class) +
                           dicom_element(2, 3, "UI", instance) + dicom_element(2, 0x10, "UI", transfer_syntax);
  std::string length(4, '\0');
  put(length, 0, static_cast<std::uint32_t>(meta.size()));
  std::string file(128, '\0');
  file += "DICM";
  file += dicom_element(2, 0, "UL", length);
  file += meta;
  return file += elements;
}

CtVolume small_ct(bool oblique) {
  Grid grid;
  grid.size = {7, 6, 5};
  grid.spacing = Vec3(0.75, 1.25, 2.5);
  grid.origin = Vec3(-12.5, 30.25, 101.0);
  if (oblique) grid.direction = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  CtVolume ct(grid);
  for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
    ct.voxels[i] = static_cast<std::int16_t>(-1000 + static_cast<int>((i * 37) % 2400));
  }
  return ct;
}

std::string nifti_bytes(const CtVolume& volume) {
  std::string header(352, '\0');
  put(header, 0, std::int32_t{348});
  put(header, 40, std::int16_t{3});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(header, 42 + 2 * axis, static_cast<std::int16_t>(volume.grid.size[axis]));
    put(header, 80 + 4 * axis, static_cast<float>(volume.grid.spacing[static_cast<Eigen::Index>(axis)]));
  }
  for (std::size_t i = 4; i < 8; ++i) put(header, 40 + 2 * i, std::int16_t{1});
  put(header, 70, std::int16_t{4});   // int16
  put(header, 72, std::int16_t{16});  // bits
  put(header, 76, 1.0F);
  put(header, 108, 352.0F);
  put(header, 112, 1.0F);
  header[123] = 2;  // mm
  put(header, 254, std::int16_t{1});
  for (Eigen::Index row = 0; row < 3; ++row) {
    const double to_ras = row < 2 ? -1.0 : 1.0;
    for (Eigen::Index column = 0; column < 3; ++column) {
      const double value = to_ras * volume.grid.direction(row, column) * volume.grid.spacing[column];
      put(header, 280 + static_cast<std::size_t>(16 * row + 4 * column), static_cast<float>(value));
    }
    put(header, 292 + static_cast<std::size_t>(16 * row), static_cast<float>(to_ras * volume.grid.origin[row]));
  }
  std::memcpy(header.data() + 344, "n+1", 4);
  return header + voxel_bytes(volume);
}

std::string nrrd_bytes(const CtVolume& volume) {
  const Grid& grid = volume.grid;
  std::string directions;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    directions += vector_text(grid.direction.col(axis) * grid.spacing[axis]);
    directions += ' ';
  }
  return fmt::format(
             "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\nspace "
             "directions: "
             "{}\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: {}\n\n",
             grid.size[0], grid.size[1], grid.size[2], directions, vector_text(grid.origin)) +
         voxel_bytes(volume);
}

std::string meta_image_bytes(const CtVolume& volume) {
  const Grid& grid = volume.grid;
  std::string matrix;
  for (Eigen::Index i = 0; i < 9; ++i) matrix += fmt::format("{:.17g} ", grid.direction.data()[i]);  // axis by axis
  return fmt::format(
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
             "False\n"
             "TransformMatrix = {}\nOffset = {:.17g} {:.17g} {:.17g}\nElementSpacing = {:.17g} {:.17g} "
             "{:.17g}\nDimSize = "
             "{} {} {}\nElementType = MET_SHORT\nElementDataFile = LOCAL\n",
             matrix, grid.origin.x(), grid.origin.y(), grid.origin.z(), grid.spacing.x(), grid.spacing.y(),
             grid.spacing.z(), grid.size[0], grid.size[1], grid.size[2]) +
         voxel_bytes(volume);
}

namespace {

// Through zlib; `window` is 15 + 16 for a gzip wrapper, -15 for none.
std::string packed_bytes(const std::string& bytes, int window) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  std::string input = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace

std::string gzip_bytes(const std::string& bytes) {
  return packed_bytes(bytes, 15 + 16);
}

std::string dicom_bytes(const DicomSliceFile& slice) {
  const std::string instance =
      slice.instance_uid.empty()
          ? fmt::format("1.2.3.{}.{}", slice.series_number, static_cast<long>(slice.position.sum() * 1000.0 + 1e7))
          : slice.instance_uid;
  const std::string ct_storage = "1.2.840.10008.5.1.4.1.1.2";
  std::string pixels(static_cast<std::size_t>(slice.columns) * static_cast<std::size_t>(slice.rows) * 2, '\0');
  for (std::size_t i = 0; i < pixels.size() / 2; ++i) {
    put(pixels, 2 * i, slice.pixels.empty() ? std::uint16_t{1024} : slice.pixels[i]);
  }
  const Vec3 &p = slice.position, &r = slice.row, &c = slice.column;
  const auto element = &dicom_element;
  const auto number_bytes = &dicom_number;
  const std::string elements =
      element(8, 0x16, "UI", ct_storage) + element(8, 0x18, "UI", instance) + element(8, 0x60, "CS", slice.modality) +
      element(8, 0x103e, "LO", "made for a test") + element(0x18, 0x50, "DS", fmt::format("{:.10g}", slice.spacing)) +
      element(0x20, 0x0d, "UI", "1.2") + element(0x20, 0x0e, "UI", slice.series_uid) +
      element(0x20, 0x11, "IS", fmt::format("{}", slice.series_number)) +
      element(0x20, 0x32, "DS", fmt::format("{:.10g}\\{:.10g}\\{:.10g}", p.x(), p.y(), p.z())) +
      element(0x20, 0x37, "DS",
              fmt::format("{:.10g}\\{:.10g}\\{:.10g}\\{:.10g}\\{:.10g}\\{:.10g}", r.x(), r.y(), r.z(), c.x(), c.y(),
                          c.z())) +
      element(0x28, 2, "US", number_bytes(1)) + element(0x28, 4, "CS", "MONOCHROME2") +
      element(0x28, 0x10, "US", number_bytes(static_cast<unsigned>(slice.rows))) +
      element(0x28, 0x11, "US", number_bytes(static_cast<unsigned>(slice.columns))) +
      element(0x28, 0x30, "DS", fmt::format("{0:.10g}\\{0:.10g}", slice.spacing)) +
      element(0x28, 0x100, "US", number_bytes(16)) + element(0x28, 0x101, "US", number_bytes(16)) +
      element(0x28, 0x102, "US", number_bytes(15)) + element(0x28, 0x103, "US", number_bytes(0)) +
      element(0x28, 0x1052, "DS", fmt::format("{:.10g}", slice.intercept)) +
      element(0x28, 0x1053, "DS", fmt::format("{:.10g}", slice.slope)) + element(0x7fe0, 0x10, "OW", pixels);
  if (!slice.deflated) return dicom_file(ct_storage, "1.2.840.10008.1.2.1", instance, elements);
  return dicom_file(ct_storage, "1.2.840.10008.1.2.1.99", instance, packed_bytes(elements, -15));
}

void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string read_file(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace bodkin::test
