#include "io/images/dicom_labels.h"

#include <cmath>
#include <map>

#include "tests/io/images/test_images.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/images/image_source.h"
#include "io/images/label_placement.h"

// DICOM segmentations and structure sets as labels.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using test::sentence_of;
using testing::HasSubstr;

constexpr const char* plain_syntax = "1.2.840.10008.1.2.1";
constexpr const char* segmentation_storage = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr const char* structure_set_storage = "1.2.840.10008.5.1.4.1.1.481.3";

Grid small_grid() {
  Grid grid;
  grid.size = {10, 8, 6};
  grid.spacing = Vec3(0.75, 1.25, 2.0);
  grid.origin = Vec3(-3.0, 4.0, 10.0);
  return grid;
}

// One frame of a segment: the voxels that `inside` chooses in slice k.
struct Frame {
  int segment, k;
};

bool in_segment(int segment, int i, int j, int k) {
  if (segment == 1) return i >= 2 && i < 9 && j >= 1 && j < 7 && k >= 1 && k < 5;  // the larger one
  return i >= 4 && i < 6 && j >= 3 && j < 5 && (k == 2 || k == 4);                 // inside it
}

// A segmentation on small_grid(): binary with a bit a pixel, or fractional with a byte.
std::string segmentation(const std::vector<Frame>& frames, bool fractional, double shift = 0.0) {
  using namespace test;
  const Grid grid = small_grid();
  std::vector<std::string> groups;
  std::vector<bool> bits;
  for (const Frame& frame : frames) {
    const Vec3 place = grid.to_patient(Vec3(0, 0, frame.k)) + Vec3(frame.k == 3 ? shift : 0.0, 0, 0);
    groups.push_back(
        dicom_sequence(0x20, 0x9113, {dicom_element(0x20, 0x32, "DS", dicom_point(place))}) +
        dicom_sequence(0x62, 0x0a,
                       {dicom_element(0x62, 0x0b, "US", dicom_number(static_cast<unsigned>(frame.segment)))}));
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) bits.push_back(in_segment(frame.segment, i, j, frame.k));
  }
  std::string pixels(fractional ? bits.size() : (bits.size() + 7) / 8, '\0');
  for (std::size_t n = 0; n < bits.size(); ++n) {
    if (fractional)
      pixels[n] = bits[n] ? '\x60' : '\x20';  // 96 and 32 of 128
    else if (bits[n])
      pixels[n / 8] = static_cast<char>(static_cast<unsigned char>(pixels[n / 8]) | (1U << (n % 8)));
  }
  const auto segment = [](unsigned number, const std::string& label) {
    return dicom_element(0x62, 4, "US", dicom_number(number)) + dicom_element(0x62, 5, "LO", label);
  };
  const std::string shared =
      dicom_sequence(0x20, 0x9116, {dicom_element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")}) +
      dicom_sequence(0x28, 0x9110,
                     {dicom_element(0x18, 0x50, "DS", "2") + dicom_element(0x18, 0x88, "DS", "2") +
                      dicom_element(0x28, 0x30, "DS", "1.25\\0.75")});
  const unsigned width = fractional ? 8 : 1;
  return dicom_file(segmentation_storage, plain_syntax, "1.2.9",
                    dicom_element(8, 0x16, "UI", segmentation_storage) + dicom_element(8, 0x18, "UI", "1.2.9") +
                        dicom_element(8, 0x60, "CS", "SEG") + dicom_element(0x20, 0x0e, "UI", "1.2.10") +
                        dicom_element(0x28, 2, "US", dicom_number(1)) + dicom_element(0x28, 4, "CS", "MONOCHROME2") +
                        dicom_element(0x28, 8, "IS", std::to_string(frames.size())) +
                        dicom_element(0x28, 0x10, "US", dicom_number(8)) +
                        dicom_element(0x28, 0x11, "US", dicom_number(10)) +
                        dicom_element(0x28, 0x100, "US", dicom_number(width)) +
                        dicom_element(0x28, 0x101, "US", dicom_number(width)) +
                        dicom_element(0x28, 0x102, "US", dicom_number(width - 1)) +
                        dicom_element(0x28, 0x103, "US", dicom_number(0)) +
                        dicom_element(0x62, 1, "CS", fractional ? "FRACTIONAL" : "BINARY") +
                        dicom_sequence(0x62, 2, {segment(1, "Liver"), segment(2, "Lesion 1")}) +
                        (fractional ? dicom_element(0x62, 0x0e, "US", dicom_number(128)) : std::string()) +
                        dicom_sequence(0x5200, 0x9229, {shared}) + dicom_sequence(0x5200, 0x9230, groups) +
                        dicom_element(0x7fe0, 0x10, fractional ? "OB" : "OW", pixels));
}

const std::vector<Frame> every_frame = {{2, 4}, {1, 1}, {1, 2}, {2, 2}, {1, 3}, {1, 4}};  // in no order

TEST(Segmentation, lies_on_the_ct_with_its_names_and_the_smaller_segment_on_top) {
  const test::ScratchFolder folder;
  for (const bool fractional : {false, true}) {
    test::write_file(folder / "seg.dcm", segmentation(every_frame, fractional));
    const NamedLabels read = read_named_labels(folder / "seg.dcm", small_grid());
    ASSERT_EQ(read.names.size(), 2U);
    EXPECT_EQ(read.names[0].name, "Liver");
    EXPECT_EQ(read.names[1].label, 2);
    EXPECT_EQ(read.names[1].name, "Lesion 1");
    EXPECT_THAT(read.notes, testing::ElementsAre(HasSubstr("overlap (voxels: 8)")));
    const LabelPlacement placed = place_labels(LabelVolume(read.labels), small_grid(), false, "seg");
    for (int k = 0; k < 6; ++k) {
      for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < 10; ++i) {
          const int expected = in_segment(2, i, j, k) ? 2 : in_segment(1, i, j, k) ? 1 : 0;
          EXPECT_EQ(placed.labels.at(i, j, k), expected) << i << " " << j << " " << k;
        }
      }
    }
  }
}

TEST(Segmentation, with_frames_on_some_slices_only_keeps_the_step_that_it_states) {
  const test::ScratchFolder folder;
  test::write_file(folder / "seg.dcm", segmentation({{2, 4}, {2, 2}}, false));
  const LabelVolume labels = read_labels(folder / "seg.dcm");
  EXPECT_EQ(labels.grid.size, (std::array<int, 3>{10, 8, 3}));
  EXPECT_EQ(labels.grid.spacing.z(), 2.0);
  EXPECT_EQ(labels.at(4, 3, 0), 2);
  EXPECT_EQ(labels.at(4, 3, 1), 0);
}

TEST(Segmentation, that_cannot_be_a_volume_is_refused) {
  const test::ScratchFolder folder;
  const auto refusal = [&](const std::string& bytes) {
    test::write_file(folder / "seg.dcm", bytes);
    return sentence_of([&] { read_labels(folder / "seg.dcm"); });
  };
  const std::string good = segmentation(every_frame, false);
  EXPECT_THAT(refusal(good.substr(0, good.size() - 20)), HasSubstr("seg.dcm"));
  EXPECT_THAT(refusal(segmentation(every_frame, false, 3.0)), HasSubstr("not stacked straight"));
}

std::string contour(const std::vector<Vec3>& points, const std::string& type = "CLOSED_PLANAR") {
  std::string data;
  for (const Vec3& point : points) data += (data.empty() ? "" : "\\") + test::dicom_point(point);
  return test::dicom_element(0x3006, 0x42, "CS", type) +
         test::dicom_element(0x3006, 0x46, "IS", std::to_string(points.size())) +
         test::dicom_element(0x3006, 0x50, "DS", data);
}

// The rectangle of voxels i0..i1 x j0..j1 of slice k, half a voxel around their centres.
std::string rectangle(int i0, int i1, int j0, int j1, double k) {
  const Grid grid = small_grid();
  const auto at = [&](double i, double j) { return grid.to_patient(Vec3(i, j, k)); };
  return contour({at(i0 - 0.4, j0 - 0.4), at(i1 + 0.4, j0 - 0.4), at(i1 + 0.4, j1 + 0.4), at(i0 - 0.4, j1 + 0.4)});
}

std::string structure_set(const std::map<int, std::vector<std::string>>& contours) {
  using namespace test;
  std::vector<std::string> names, drawn;
  for (const auto& [number, items] : contours) {
    names.push_back(dicom_element(0x3006, 0x22, "IS", std::to_string(number)) +
                    dicom_element(0x3006, 0x26, "LO", "structure " + std::to_string(number)));
    drawn.push_back(dicom_sequence(0x3006, 0x40, items) + dicom_element(0x3006, 0x84, "IS", std::to_string(number)));
  }
  return dicom_file(structure_set_storage, plain_syntax, "1.2.11",
                    dicom_element(8, 0x16, "UI", structure_set_storage) + dicom_element(8, 0x18, "UI", "1.2.11") +
                        dicom_element(8, 0x60, "CS", "RTSTRUCT") + dicom_element(0x20, 0x0e, "UI", "1.2.12") +
                        dicom_sequence(0x3006, 0x20, names) + dicom_sequence(0x3006, 0x39, drawn));
}

TEST(StructureSet, contours_fill_the_voxels_whose_centres_they_hold) {
  const test::ScratchFolder folder;
  // 3 has a hole in slice 2, 7 lies on every second slice, and inside 3 where they meet.
  test::write_file(folder / "rs.dcm",
                   structure_set({{3, {rectangle(1, 8, 1, 6, 2), rectangle(3, 5, 3, 4, 2), rectangle(1, 8, 1, 6, 3)}},
                                  {7, {rectangle(7, 8, 5, 7, 1.0), rectangle(7, 8, 5, 7, 3.0)}}}));
  const NamedLabels read = read_named_labels(folder / "rs.dcm", small_grid());
  ASSERT_EQ(read.names.size(), 2U);
  EXPECT_EQ(read.names[1].name, "structure 7");
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 10; ++i) {
        const bool in_seven = i >= 7 && i <= 8 && j >= 5 && j <= 7 && k <= 4;  // and half a step beyond
        const bool hole = i >= 3 && i <= 5 && j >= 3 && j <= 4 && k == 2;
        const bool in_three = i >= 1 && i <= 8 && j >= 1 && j <= 6 && (k == 2 || k == 3) && !hole;
        EXPECT_EQ(read.labels.at(i, j, k), in_seven ? 7 : in_three ? 3 : 0) << i << " " << j << " " << k;
      }
    }
  }
  EXPECT_THAT(sentence_of([&] { read_labels(folder / "rs.dcm"); }), HasSubstr("--labels of its CT"));
}

TEST(StructureSet, that_does_not_lie_in_slices_or_is_empty_is_refused) {
  const test::ScratchFolder folder;
  const auto refusal = [&](const std::string& item) {
    test::write_file(folder / "rs.dcm", structure_set({{1, {item}}}));
    return sentence_of([&] { read_named_labels(folder / "rs.dcm", small_grid()); });
  };
  EXPECT_THAT(refusal(contour({Vec3(0, 5, 10), Vec3(3, 9, 14), Vec3(1, 12, 19)})), HasSubstr("slices of the CT"));
  EXPECT_THAT(refusal(contour({Vec3(0, 5, 10)}, "POINT")), HasSubstr("no closed contours"));
  EXPECT_THAT(refusal(contour({Vec3(0, 5, 10), Vec3(3e7, 9, 10), Vec3(1, 12, 10)})), HasSubstr("it is damaged"));
}

TEST(LabelSource, the_only_segmentation_of_a_folder_is_found_and_several_are_listed) {
  const test::ScratchFolder folder;
  test::write_file(folder / "ct.dcm", test::dicom_bytes({}));
  test::write_file(folder / "one.dcm", segmentation(every_frame, false));
  EXPECT_EQ(read_named_labels(folder.path(), small_grid()).names.size(), 2U);
  test::write_file(folder / "two.dcm", segmentation(every_frame, true));
  const std::string sentence = sentence_of([&] { read_named_labels(folder.path(), small_grid()); });
  EXPECT_THAT(sentence, HasSubstr("2 segmentations"));
  EXPECT_THAT(sentence, HasSubstr("two.dcm: SEG"));
}

// Twice the common voxels among all labelled ones.
double overlap(const LabelVolume& a, std::uint16_t label_a, const LabelVolume& b, std::uint16_t label_b) {
  double both = 0.0, either = 0.0;
  for (std::size_t n = 0; n < a.voxels.size(); ++n) {
    both += a.voxels[n] == label_a && b.voxels[n] == label_b ? 2.0 : 0.0;
    either += (a.voxels[n] == label_a ? 1.0 : 0.0) + (b.voxels[n] == label_b ? 1.0 : 0.0);
  }
  return both / either;
}

TEST(LabelSource, real_objects_hold_what_others_made_of_them) {
  BODKIN_REQUIRE_DATA(data);
  {
    const Grid ct = read_ct(data / "dicom_3slice_nrrd_labels/series").ct.grid;
    const NamedLabels seg = read_named_labels(data / "dicom_3slice_nrrd_labels/liver_dicom_seg.dcm", ct);
    ASSERT_EQ(seg.names.size(), 1U);
    EXPECT_THAT(seg.names[0].name, HasSubstr("iver"));
    const LabelVolume liver = place_labels(LabelVolume(seg.labels), ct, false, "seg").labels;
    const LabelVolume same =
        place_labels(read_labels(data / "dicom_3slice_nrrd_labels/liver_seg.nrrd"), ct, false, "nrrd").labels;
    EXPECT_EQ(overlap(liver, seg.names[0].label, same, 1), 1.0);
  }
  const Grid ct = read_ct(data / "dicom_ct_lumbosacral/series").ct.grid;
  const NamedLabels set = read_named_labels(data / "dicom_ct_lumbosacral/rtstruct", ct);
  ASSERT_EQ(set.names.size(), 1U);
  EXPECT_EQ(set.names[0].name, "GTV_Mass_CT");
  const LabelVolume mask =
      place_labels(read_labels(data / "dicom_ct_lumbosacral/mass_mask.nii.gz"), ct, false, "mask").labels;
  EXPECT_GT(overlap(set.labels, set.names[0].label, mask, 1), 0.97);
}

}  // namespace
}  // namespace bodkin
