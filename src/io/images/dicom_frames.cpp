#include "io/images/dicom_frames.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gdcmDataSet.h>
#include <gdcmTag.h>

#include "io/images/dicom_elements.h"

namespace bodkin::io {
namespace {

const gdcm::Tag shared_groups(0x5200, 0x9229), groups_of_frames(0x5200, 0x9230);
const gdcm::Tag plane_position(0x0020, 0x9113), plane_orientation(0x0020, 0x9116), pixel_measures(0x0028, 0x9110);
const gdcm::Tag value_transformation(0x0028, 0x9145), segment_identification(0x0062, 0x000a);

std::optional<ImagePlacement> placement_from(const std::vector<double>& position, const std::vector<double>& cosines,
                                             const std::vector<double>& spacing) {
  if (position.size() != 3 || cosines.size() != 6 || spacing.size() != 2) return std::nullopt;
  ImagePlacement placement;
  placement.position = Vec3(position[0], position[1], position[2]);
  placement.row_spacing = spacing[0];  // DICOM gives the spacing between rows first
  placement.column_spacing = spacing[1];
  const Vec3 row(cosines[0], cosines[1], cosines[2]);
  const Vec3 column(cosines[3], cosines[4], cosines[5]);
  if (std::abs(row.norm() - 1.0) > 1e-2 || std::abs(column.norm() - 1.0) > 1e-2) return std::nullopt;
  if (std::abs(row.dot(column)) > 1e-2 || !(std::min(spacing[0], spacing[1]) > 0.0)) return std::nullopt;
  placement.row_direction = row.normalized();
  placement.column_direction = (column - column.dot(placement.row_direction) * placement.row_direction).normalized();
  return placement;
}

// The contents of a frame's functional groups; missing values are unchanged.
struct FrameGroups {
  std::vector<double> position, cosines, spacing;
  double thickness = 0.0, slope = 1.0, intercept = 0.0;
  int segment = 0;

  void read(const gdcm::DataSet& groups) {
    if (const auto item = first_item_of(groups, plane_position)) position = numbers_of(*item, {0x0020, 0x0032}, 3);
    if (const auto item = first_item_of(groups, plane_orientation)) cosines = numbers_of(*item, {0x0020, 0x0037}, 6);
    if (const auto item = first_item_of(groups, pixel_measures)) {
      spacing = numbers_of(*item, {0x0028, 0x0030}, 2);
      thickness = number_of(*item, {0x0018, 0x0050}, thickness);
    }
    if (const auto item = first_item_of(groups, value_transformation)) {
      slope = number_of(*item, {0x0028, 0x1053}, slope);
      intercept = number_of(*item, {0x0028, 0x1052}, intercept);
    }
    if (const auto item = first_item_of(groups, segment_identification))
      segment = unsigned_short_of(*item, {0x0062, 0x000b});
  }
};

}  // namespace

std::optional<ImagePlacement> read_placement(const gdcm::DataSet& data) {
  return placement_from(numbers_of(data, {0x0020, 0x0032}, 3), numbers_of(data, {0x0020, 0x0037}, 6),
                        numbers_of(data, {0x0028, 0x0030}, 2));
}

std::vector<FrameInfo> read_frames(const gdcm::DataSet& data) {
  FrameGroups shared;
  if (const auto item = first_item_of(data, shared_groups)) shared.read(*item);
  std::vector<FrameInfo> frames;
  for (const gdcm::DataSet& item : items_of(data, groups_of_frames)) {
    FrameGroups own = shared;
    own.read(item);
    const auto placement = placement_from(own.position, own.cosines, own.spacing);
    if (!placement) return {};
    frames.push_back({*placement, own.thickness, own.slope, own.intercept, own.segment});
  }
  return frames;
}

}  // namespace bodkin::io
