#include <cmath>
#include <numbers>

#include "tests/io/images/test_images.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "io/digest.h"
#include "io/images/image_source.h"
#include "io/images/image_values.h"
#include "io/images/label_placement.h"
#include "io/images/slice_stack.h"
#include "io/nrrd_reader.h"
#include "io/nrrd_writer.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using test::sentence_of;
using testing::HasSubstr;

SliceStack stack_at(const std::vector<Vec3>& positions) {
  SliceStack stack;
  stack.columns = 9;
  stack.rows = 8;
  stack.column_spacing = 1.0;
  stack.row_spacing = 2.0;
  stack.positions = positions;
  return stack;
}

// A stack whose voxels are a linear function of place, which linear interpolation reproduces exactly.
std::vector<std::int16_t> sampled(const SliceStack& stack, const Vec3& slope) {
  std::vector<std::int16_t> voxels;
  for (const Vec3& position : stack.positions) {
    for (int j = 0; j < stack.rows; ++j) {
      for (int i = 0; i < stack.columns; ++i) {
        const Vec3 place = position + i * stack.column_spacing * stack.row_direction +
                           j * stack.row_spacing * stack.column_direction;
        voxels.push_back(static_cast<std::int16_t>(std::lround(slope.dot(place))));
      }
    }
  }
  return voxels;
}

TEST(SliceStack, even_steps_are_regular_and_carried_exactly) {
  const SliceStack stack = stack_at({{1, 2, 10}, {1, 2, 12.5}, {1, 2, 15}});
  const StackGeometry geometry = measure_stack(stack, 1.0);
  EXPECT_TRUE(geometry.regular());
  const Grid grid = regular_grid(stack, geometry);
  EXPECT_EQ(grid.spacing, Vec3(1.0, 2.0, 2.5));
  EXPECT_EQ(grid.origin, Vec3(1, 2, 10));
  EXPECT_EQ(grid.axes(), "LPS");
}

TEST(SliceStack, positions_rounded_to_hundredths_are_still_even) {
  EXPECT_TRUE(measure_stack(stack_at({{0, 0, 0}, {0, 0, 0.63}, {0, 0, 1.25}, {0, 0, 1.88}}), 1.0).regular());
}

TEST(SliceStack, a_single_slice_is_as_thick_as_its_header_says) {
  EXPECT_EQ(measure_stack(stack_at({{0, 0, 0}}), 5.0).step, 5.0);
}

TEST(SliceStack, a_gap_of_whole_steps_is_a_missing_slice) {
  const StackGeometry geometry = measure_stack(stack_at({{0, 0, 0}, {0, 0, 5}, {0, 0, 10}, {0, 0, 20}}), 5.0);
  EXPECT_THAT(geometry.gaps, testing::ElementsAre(2U));
  EXPECT_EQ(geometry.step, 5.0);
  EXPECT_EQ(geometry.largest_step, 10.0);
}

TEST(SliceStack, steps_of_no_common_measure_are_uneven_and_nothing_is_missing) {
  const StackGeometry geometry =
      measure_stack(stack_at({{0, 0, 0}, {0, 0, 2}, {0, 0, 4}, {0, 0, 7}, {0, 0, 10.3}}), 2.0);
  EXPECT_TRUE(geometry.uneven);
  EXPECT_TRUE(geometry.gaps.empty());
}

TEST(SliceStack, resampling_uneven_slices_reproduces_a_linear_field) {
  const Vec3 slope(20.0, -15.0, 40.0);
  const SliceStack stack = stack_at({{0, 0, 0}, {0, 0, 2}, {0, 0, 5}, {0, 0, 8}, {0, 0, 12}});
  const StackGeometry geometry = measure_stack(stack, 1.0);
  const CtVolume volume = resample_stack(stack, resampled_grid(stack, geometry), sampled(stack, slope), -1024);
  EXPECT_EQ(volume.grid.size[0], 9);
  EXPECT_EQ(volume.grid.size[1], 8);
  EXPECT_NEAR(volume.grid.spacing.z(), 3.0, 1e-12);
  for (int k = 0; k < volume.grid.size[2]; ++k) {
    const Vec3 place = volume.grid.to_patient(Vec3(4, 3, k));
    EXPECT_NEAR(volume.at(4, 3, k), slope.dot(place), 1.0) << k;
  }
}

TEST(SliceStack, a_tilt_is_measured_and_straightened) {
  const double angle = 18.5 * std::numbers::pi / 180.0;
  SliceStack stack = stack_at({});
  stack.column_direction = Vec3(0.0, std::cos(angle), -std::sin(angle));
  for (int k = 0; k < 6; ++k) stack.positions.emplace_back(3.0, -5.0, 2.5 * k);
  const StackGeometry geometry = measure_stack(stack, 2.5);
  EXPECT_TRUE(geometry.sheared);
  EXPECT_FALSE(geometry.uneven);
  EXPECT_NEAR(geometry.shear_angle, 18.5, 1e-9);
  EXPECT_NEAR(geometry.step, 2.5 * std::cos(angle), 1e-12);
  const Vec3 slope(10.0, 25.0, -30.0);
  const CtVolume volume = resample_stack(stack, resampled_grid(stack, geometry), sampled(stack, slope), -1024);
  int inside = 0;
  for (int k = 0; k < volume.grid.size[2]; ++k) {
    for (int j = 0; j < volume.grid.size[1]; ++j) {
      if (volume.at(4, j, k) == -1024) continue;
      EXPECT_NEAR(volume.at(4, j, k), slope.dot(volume.grid.to_patient(Vec3(4, j, k))), 1.0);
      ++inside;
    }
  }
  EXPECT_GE(inside, 6 * 7);  // each slice keeps its rows, but for one at the border
}

TEST(DicomSeries, slices_are_ordered_by_place_not_by_name_and_repetitions_read_once) {
  const test::ScratchFolder folder;
  for (int k = 0; k < 4; ++k) {
    test::DicomSliceFile slice;
    slice.position = Vec3(0, 0, 2.0 * k);
    slice.pixels.assign(12, static_cast<std::uint16_t>(1000 + k));
    test::write_file(folder / ("slice" + std::to_string(9 - k)), test::dicom_bytes(slice));
    if (k == 1) test::write_file(folder / "copy", test::dicom_bytes(slice));
  }
  test::write_file(folder / "readme.txt", "not an image");
  const CtImage image = read_ct(folder.path());
  EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{4, 3, 4}));
  for (int k = 0; k < 4; ++k) EXPECT_EQ(image.ct.at(0, 0, k), 1000 + k - 1024);
  EXPECT_THAT(image.notes, testing::ElementsAre(HasSubstr("read once")));
}

TEST(DicomSeries, several_series_are_listed_and_one_is_picked_by_its_number) {
  const test::ScratchFolder folder;
  for (int series = 1; series <= 2; ++series) {
    for (int k = 0; k < 2; ++k) {
      test::DicomSliceFile slice;
      slice.series_uid = "1.2." + std::to_string(series);
      slice.series_number = 10 * series;
      slice.position = Vec3(0, 0, k);
      slice.pixels.assign(12, static_cast<std::uint16_t>(1000 + series));
      test::write_file(folder / (std::to_string(series) + "_" + std::to_string(k)), test::dicom_bytes(slice));
    }
  }
  const std::string sentence = sentence_of([&] { read_ct(folder.path()); });
  EXPECT_THAT(sentence, HasSubstr("1: series 10 'made for a test', CT, 2 slices of 4 x 3"));
  EXPECT_THAT(sentence, HasSubstr("2: series 20"));
  DicomOptions second;
  second.series = 2;
  EXPECT_EQ(read_ct(folder.path(), second).ct.at(0, 0, 0), 1002 - 1024);
  second.series = 3;
  EXPECT_THAT(sentence_of([&] { read_ct(folder.path(), second); }), HasSubstr("there is no series 3"));
}

TEST(DicomSeries, what_cannot_be_one_ct_is_refused) {
  const auto refusal = [](test::DicomSliceFile first, test::DicomSliceFile second) {
    const test::ScratchFolder folder;
    test::write_file(folder / "a", test::dicom_bytes(first));
    test::write_file(folder / "b", test::dicom_bytes(second));
    return sentence_of([&] { read_ct(folder.path()); });
  };
  test::DicomSliceFile a, b;
  b.position.z() = 1.0;
  test::DicomSliceFile mr_a = a, mr_b = b;
  mr_a.modality = mr_b.modality = "MR";
  EXPECT_THAT(refusal(mr_a, mr_b), HasSubstr("modality MR), not CT"));
  test::DicomSliceFile same_place = a;
  same_place.instance_uid = "1.2.77";
  EXPECT_THAT(refusal(a, same_place), HasSubstr("two different slices lie at z = 0.00 mm"));
  test::DicomSliceFile other_size = b;
  other_size.columns = 5;
  EXPECT_THAT(refusal(a, other_size), HasSubstr("this folder holds 2 series"));
  test::DicomSliceFile turned = b;
  turned.row = Vec3::UnitY();
  turned.column = Vec3::UnitZ();
  EXPECT_THAT(refusal(a, turned), HasSubstr("this folder holds 2 series"));
  test::DicomSliceFile far = b;
  far.position = Vec3(500, 0, 1);
  EXPECT_THAT(refusal(a, far), HasSubstr("more than any gantry tilts"));
  const test::ScratchFolder empty;
  EXPECT_THAT(sentence_of([&] { read_ct(empty.path()); }), HasSubstr("no DICOM image here"));
}

TEST(Labels, any_axis_order_and_direction_of_the_same_voxels_is_only_reindexed) {
  const CtVolume ct = test::small_ct();
  LabelVolume expected(ct.grid);
  for (std::size_t i = 0; i < expected.voxels.size(); ++i) expected.voxels[i] = static_cast<std::uint16_t>(1 + i);
  // The same voxels stored with i and k exchanged and j backwards.
  Grid turned;
  turned.size = {ct.grid.size[2], ct.grid.size[1], ct.grid.size[0]};
  turned.spacing = Vec3(ct.grid.spacing.z(), ct.grid.spacing.y(), ct.grid.spacing.x());
  turned.direction << ct.grid.direction.col(2), -ct.grid.direction.col(1), ct.grid.direction.col(0);
  turned.origin = ct.grid.to_patient(Vec3(0, ct.grid.size[1] - 1, 0));
  LabelVolume labels(turned);
  for (int k = 0; k < turned.size[2]; ++k) {
    for (int j = 0; j < turned.size[1]; ++j) {
      for (int i = 0; i < turned.size[0]; ++i) labels.at(i, j, k) = expected.at(k, ct.grid.size[1] - 1 - j, i);
    }
  }
  const LabelPlacement placed = place_labels(std::move(labels), ct.grid, false, "labels");
  EXPECT_EQ(placed.labels.voxels, expected.voxels);
  EXPECT_TRUE(placed.notes.empty());
}

TEST(Labels, a_shift_by_half_a_voxel_is_refused_with_its_size_or_resampled_when_asked) {
  const CtVolume ct = test::small_ct();
  LabelVolume labels(ct.grid, 3);
  labels.grid.origin += ct.grid.direction.col(0) * (0.4 * ct.grid.spacing.x());
  EXPECT_THAT(sentence_of([&] { place_labels(LabelVolume(labels), ct.grid, false, "labels"); }),
              HasSubstr("up to 0.40 voxels off"));
  const LabelPlacement placed = place_labels(LabelVolume(labels), ct.grid, true, "labels");
  EXPECT_EQ(placed.labels.at(3, 3, 3), 3);
  EXPECT_THAT(placed.notes, testing::ElementsAre(HasSubstr("nearest label")));
  labels.grid.origin += Vec3(1000, 0, 0);
  EXPECT_THAT(sentence_of([&] { place_labels(LabelVolume(labels), ct.grid, true, "labels"); }),
              HasSubstr("no labelled voxel lies inside the CT"));
}

TEST(Hounsfield, values_are_exact_in_range_and_losses_are_told) {
  ImageFile file;
  file.grid.size = {5, 1, 1};
  file.voxels = std::vector<float>{-3024.0F, -1000.0F, 40.25F, 99999.0F, std::nanf("")};
  std::vector<std::string> notes;
  const CtVolume ct = to_ct(std::move(file), notes);
  EXPECT_EQ(ct.voxels, (std::vector<std::int16_t>{-1024, -1000, 40, 32767, -1024}));
  EXPECT_THAT(
      notes, testing::UnorderedElementsAre(HasSubstr("at most 0.25 HU"),
                                           HasSubstr("below -1024 HU (padding outside the scanned field; voxels: 1)"),
                                           HasSubstr("above 32767 HU (voxels: 1)"), HasSubstr("not a number")));
}

TEST(NrrdWriter, what_was_written_is_read_back_to_the_bit) {
  const test::ScratchFolder folder;
  const CtVolume ct = test::small_ct();
  write_nrrd(ct, folder / "ct.nrrd");
  const CtVolume read = read_ct(folder / "ct.nrrd").ct;
  EXPECT_EQ(read.voxels, ct.voxels);
  EXPECT_EQ(read.grid.spacing, ct.grid.spacing);
  EXPECT_EQ(read.grid.origin, ct.grid.origin);
  EXPECT_EQ(read.grid.direction, ct.grid.direction);
  EXPECT_EQ(volume_digest(read), volume_digest(ct));
  LabelVolume labels(ct.grid, 65535);
  write_nrrd(labels, folder / "labels.nrrd");
  EXPECT_EQ(read_labels(folder / "labels.nrrd").voxels, labels.voxels);
  TissueVolume tissues(ct.grid, 21);
  write_nrrd(tissues, folder / "tissues.nrrd");
  EXPECT_EQ(read_tissues(folder / "tissues.nrrd").voxels, tissues.voxels);
}

TEST(NrrdWriter, an_oblique_grid_keeps_its_digest_and_its_numbers_to_a_trillionth) {
  const test::ScratchFolder folder;
  const CtVolume ct = test::small_ct(true);
  write_nrrd(ct, folder / "ct.nrrd");
  const CtVolume read = read_ct(folder / "ct.nrrd").ct;
  EXPECT_LT((read.grid.direction - ct.grid.direction).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((read.grid.spacing - ct.grid.spacing).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(read.grid.origin, ct.grid.origin);
  EXPECT_EQ(volume_digest(read), volume_digest(ct));
}

// Sessions recorded with a case that the image worker read must replay when Bodkin reads it itself.
TEST(NrrdReader, gives_the_bits_of_the_imaging_library) {
  const test::ScratchFolder folder;
  Random random(3);
  for (int turn = 0; turn < 40; ++turn) {
    CtVolume ct = test::small_ct(false);
    const Vec3 axis(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    if (turn > 0)
      ct.grid.direction = Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis.normalized()).toRotationMatrix();
    for (Eigen::Index i = 0; i < 3; ++i) ct.grid.spacing[i] = random.uniform(0.1, 5.0);
    write_nrrd(ct, folder / "ct.nrrd");
    const CtVolume library = read_ct(folder / "ct.nrrd").ct;
    const auto own = read_nrrd<std::int16_t>(folder / "ct.nrrd");
    ASSERT_TRUE(own.has_value());
    EXPECT_EQ(own->voxels, library.voxels);
    EXPECT_EQ(own->grid.spacing, library.grid.spacing) << turn;
    EXPECT_EQ(own->grid.direction, library.grid.direction) << turn;
    EXPECT_EQ(own->grid.origin, library.grid.origin) << turn;
  }
}

TEST(Digest, one_voxel_or_a_micrometre_changes_it) {
  CtVolume ct = test::small_ct();
  const std::string before = volume_digest(ct);
  EXPECT_EQ(before.size(), 32U);
  ct.grid.origin.x() += 1e-3;
  EXPECT_NE(volume_digest(ct), before);
  ct.grid.origin.x() -= 1e-3;
  EXPECT_EQ(volume_digest(ct), before);
  ct.voxels[17] ^= 1;
  EXPECT_NE(volume_digest(ct), before);
}

}  // namespace
}  // namespace bodkin
