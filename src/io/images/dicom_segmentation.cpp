#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <gdcmDataSet.h>
#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmTag.h>

#include "core/error.h"
#include "io/image_grid.h"
#include "io/images/dicom_elements.h"
#include "io/images/dicom_extent.h"
#include "io/images/dicom_frames.h"
#include "io/images/dicom_labels.h"
#include "io/text_encoding.h"

namespace bodkin::io {
namespace {

constexpr std::uintmax_t segmentation_memory = 256U << 20U;  // bytes in addition to four times the file's
constexpr int most_planes = 5000;                            // along the normal; an image has no more slices
constexpr double same_plane = 0.01;                          // mm
constexpr double plane_tolerance = 0.05;                     // of a step

// The frames of a segmentation as it stores them.
struct Segmentation {
  std::string name;  // of the file
  int columns = 0, rows = 0;
  std::vector<FrameInfo> frames;
  std::vector<LabelName> names;
  bool label_map = false;
  int bits = 1;             // of a stored pixel: 1, 8 or 16
  int threshold = 1;        // stored values from here on belong to the segment
  double step = 0.0;        // mm, Spacing Between Slices; 0 = not given
  std::vector<char> bytes;  // of the pixels, frame after frame without padding

  std::size_t frame_size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  unsigned stored(std::size_t pixel) const {
    const auto byte = [&](std::size_t place) {
      return static_cast<unsigned>(static_cast<unsigned char>(bytes[place]));
    };
    if (bits == 1) return (byte(pixel / 8) >> (pixel % 8)) & 1U;
    return bits == 8 ? byte(pixel) : byte(2 * pixel) + 256 * byte(2 * pixel + 1);
  }
};

[[noreturn]] void refuse_segmentation(const std::string& name, const std::string& why) {
  throw InputError(fmt::format("{}: this DICOM segmentation {}", name, why));
}

std::vector<LabelName> segment_names(const gdcm::DataSet& data) {
  std::vector<LabelName> names;
  for (const gdcm::DataSet& segment : items_of(data, {0x0062, 0x0002})) {
    const int number = unsigned_short_of(segment, {0x0062, 0x0004});
    if (number < 1) continue;
    names.push_back({static_cast<std::uint16_t>(number), printable(text_of(segment, {0x0062, 0x0005}))});
  }
  return names;
}

// The pixels as bytes, unpacked if they are compressed.
std::vector<char> pixel_bytes(const gdcm::File& file, const std::string& name, std::size_t needed) {
  const gdcm::Tag pixel_data(0x7fe0, 0x0010);
  std::vector<char> bytes;
  if (file.GetDataSet().FindDataElement(pixel_data)) {
    const gdcm::ByteValue* value = file.GetDataSet().GetDataElement(pixel_data).GetByteValue();
    if (value != nullptr && value->GetPointer() != nullptr && value->GetLength() >= needed) {
      bytes.assign(value->GetPointer(), value->GetPointer() + needed);
    } else if (file.GetDataSet().GetDataElement(pixel_data).GetSequenceOfFragments() != nullptr) {
      gdcm::ImageReader reader;
      reader.SetFileName(name.c_str());
      if (reader.Read() && reader.GetImage().GetBufferLength() == needed) {
        bytes.resize(needed);
        if (!reader.GetImage().GetBuffer(bytes.data())) bytes.clear();
      }
    }
  }
  if (bytes.empty())
    refuse_segmentation(name, "has fewer pixels than its header declares; it is truncated or damaged");
  return bytes;
}

Segmentation read_frames_of(const std::filesystem::path& path) {
  Segmentation found;
  found.name = path.string();
  const DicomExtent extent = dicom_extent(path);
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  if (extent.header_cut || extent.pixels_cut || !reader.Read())
    refuse_segmentation(found.name, "cannot be read; it is truncated or damaged, copy it again");
  const gdcm::File& file = reader.GetFile();
  const gdcm::DataSet& data = file.GetDataSet();
  found.rows = unsigned_short_of(data, {0x0028, 0x0010});
  found.columns = unsigned_short_of(data, {0x0028, 0x0011});
  found.bits = unsigned_short_of(data, {0x0028, 0x0100});
  found.frames = read_frames(data);
  found.names = segment_names(data);
  const std::string type = text_of(data, {0x0062, 0x0001});
  found.label_map = type == "LABELMAP";
  if (type == "FRACTIONAL") found.threshold = std::max(1, (unsigned_short_of(data, {0x0062, 0x000e}, 255) + 1) / 2);
  if (const auto shared = first_item_of(data, {0x5200, 0x9229})) {
    if (const auto measures = first_item_of(*shared, {0x0028, 0x9110}))
      found.step = number_of(*measures, {0x0018, 0x0088}, 0.0);
  }
  if (found.bits != 1 && found.bits != 8 && found.bits != 16)
    refuse_segmentation(found.name, fmt::format("stores {} bits a pixel; expected 1, 8 or 16", found.bits));
  if (found.frames.empty() || found.rows == 0 || found.columns == 0)
    refuse_segmentation(found.name, "does not say where its frames lie in the patient");
  const std::size_t pixels = found.frame_size() * found.frames.size();
  require_plausible_size(found.name, {found.frame_size(), found.frames.size()}, 1, static_cast<double>(most_voxels));
  found.bytes = pixel_bytes(file, found.name, (pixels * static_cast<std::size_t>(found.bits) + 7) / 8);
  return found;
}

// The lattice of the frames, and the slice of each frame.
struct FrameLattice {
  anatomy::Grid grid;
  std::vector<int> slice;
};

// Whether all heights are whole steps.
bool whole_steps(std::span<const double> heights, double step) {
  return std::all_of(heights.begin(), heights.end(), [&](double height) {
    return std::abs(height - step * std::round(height / step)) <= plane_tolerance * step;
  });
}

FrameLattice frame_lattice(const Segmentation& found) {
  const ImagePlacement& first = found.frames.front().placement;
  const Vec3 normal = first.row_direction.cross(first.column_direction);
  std::vector<double> heights;
  for (const FrameInfo& frame : found.frames) {
    const Vec3 moved = frame.placement.position - first.position;
    const bool turned = (frame.placement.row_direction - first.row_direction).norm() > 1e-3 ||
                        (frame.placement.column_direction - first.column_direction).norm() > 1e-3;
    const bool shifted = std::abs(moved.dot(first.row_direction)) > 0.1 * first.column_spacing ||
                         std::abs(moved.dot(first.column_direction)) > 0.1 * first.row_spacing;
    if (turned || shifted) refuse_segmentation(found.name, "has frames that are not stacked straight on each other");
    heights.push_back(moved.dot(normal));
  }
  const double lowest = *std::min_element(heights.begin(), heights.end());
  for (double& height : heights) height -= lowest;
  std::vector<double> planes = heights;
  std::sort(planes.begin(), planes.end());
  double smallest = 0.0;
  for (std::size_t n = 1; n < planes.size(); ++n) {
    const double gap = planes[n] - planes[n - 1];
    if (gap > same_plane && (smallest == 0.0 || gap < smallest)) smallest = gap;
  }
  double step = smallest;
  if (found.step > 0.0 && whole_steps(planes, found.step)) step = found.step;
  if (step == 0.0) step = found.frames.front().thickness > 0.0 ? found.frames.front().thickness : 1.0;
  if (!whole_steps(planes, step)) refuse_segmentation(found.name, "has frames at uneven distances");
  if (planes.back() / step > most_planes)
    refuse_segmentation(found.name,
                        fmt::format("has frames {:.0f} mm apart, {:.4g} mm being a step", planes.back(), step));

  FrameLattice lattice;
  for (const double height : heights) lattice.slice.push_back(static_cast<int>(std::lround(height / step)));
  lattice.grid.size = {found.columns, found.rows, 1 + static_cast<int>(std::lround(planes.back() / step))};
  lattice.grid.spacing = Vec3(first.column_spacing, first.row_spacing, step);
  lattice.grid.direction << first.row_direction, first.column_direction, normal;
  lattice.grid.origin = first.position + lowest * normal;
  lattice.grid = clean_grid(lattice.grid, found.name);
  require_plausible_size(
      found.name,
      {static_cast<std::uintmax_t>(lattice.grid.size[0]), static_cast<std::uintmax_t>(lattice.grid.size[1]),
       static_cast<std::uintmax_t>(lattice.grid.size[2])},
      1, static_cast<double>(most_voxels));
  return lattice;
}

// The segments by size, largest first: smaller ones are drawn over it.
std::vector<int> drawing_order(const Segmentation& found) {
  std::map<int, std::size_t> sizes;
  for (std::size_t n = 0; n < found.frames.size(); ++n) {
    std::size_t& size = sizes[found.frames[n].segment];
    const std::size_t from = n * found.frame_size();
    for (std::size_t i = 0; i < found.frame_size(); ++i)
      size += static_cast<int>(found.stored(from + i)) >= found.threshold ? 1 : 0;
  }
  std::vector<std::pair<std::size_t, int>> by_size;
  for (const auto& [segment, size] : sizes) by_size.emplace_back(size, segment);
  std::sort(by_size.rbegin(), by_size.rend());
  std::vector<int> order;
  for (const auto& [size, segment] : by_size) order.push_back(segment);
  return order;
}

NamedLabels draw_frames(const Segmentation& found) {
  const FrameLattice lattice = frame_lattice(found);
  NamedLabels result;
  result.labels = anatomy::LabelVolume(lattice.grid);
  result.names = found.names;
  std::size_t overlapping = 0;
  const auto draw = [&](std::size_t frame) {
    std::uint16_t* voxel = &result.labels.at(0, 0, lattice.slice[frame]);
    const std::size_t from = frame * found.frame_size();
    const auto segment = static_cast<std::uint16_t>(found.frames[frame].segment);
    for (std::size_t i = 0; i < found.frame_size(); ++i, ++voxel) {
      const unsigned stored = found.stored(from + i);
      if (found.label_map ? stored == 0 : static_cast<int>(stored) < found.threshold) continue;
      const auto label = found.label_map ? static_cast<std::uint16_t>(stored) : segment;
      overlapping += *voxel != 0 && *voxel != label ? 1 : 0;
      *voxel = label;
    }
  };
  std::vector<int> order = {0};
  if (!found.label_map) order = drawing_order(found);
  for (const int segment : order) {
    for (std::size_t frame = 0; frame < found.frames.size(); ++frame) {
      if (found.label_map || found.frames[frame].segment == segment) draw(frame);
    }
  }
  if (overlapping > 0)
    result.notes.push_back(
        fmt::format("Where segments overlap (voxels: {}) the smaller one was taken.", overlapping));
  return result;
}

}  // namespace

NamedLabels read_segmentation(const std::filesystem::path& file) {
  Segmentation found;
  const bool read = read_within_budget(file, segmentation_memory, [&] {
    found = read_frames_of(file);
    return true;
  });
  if (!read) refuse_segmentation(file.string(), "declares more than the file holds; it is truncated or damaged");
  if (!found.label_map && std::any_of(found.frames.begin(), found.frames.end(),
                                      [](const FrameInfo& frame) { return frame.segment < 1; })) {
    refuse_segmentation(file.string(), "has frames that belong to no segment");
  }
  return draw_frames(found);
}

}  // namespace bodkin::io
