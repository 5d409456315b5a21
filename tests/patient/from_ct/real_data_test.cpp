#include <algorithm>
#include <cmath>

#include "tests/io/images/test_images.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/images/image_source.h"
#include "io/images/image_values.h"
#include "io/images/label_placement.h"

// Every CT and label set of the real data, with the outcome that its README documents.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using test::sentence_of;
using testing::HasSubstr;

double mean_where(const CtVolume& ct, const LabelVolume& labels, std::uint16_t label) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
    if (labels.voxels[i] != label) continue;
    sum += ct.voxels[i];
    ++count;
  }
  return count == 0 ? std::nan("") : sum / static_cast<double>(count);
}

// Share of a structure's voxels whose HU lie in a range.
double share_where(const CtVolume& ct, const LabelVolume& labels, std::uint16_t label, int least, int most) {
  double inside = 0.0, all = 0.0;
  for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
    if (labels.voxels[i] != label) continue;
    all += 1.0;
    inside += ct.voxels[i] >= least && ct.voxels[i] <= most ? 1.0 : 0.0;
  }
  return inside / all;
}

std::pair<int, int> range_of(const CtVolume& ct) {
  const auto [least, most] = std::minmax_element(ct.voxels.begin(), ct.voxels.end());
  return {*least, *most};
}

LabelVolume labels_on(const CtVolume& ct, const std::filesystem::path& file) {
  return place_labels(read_labels(file), ct.grid, false, file.string()).labels;
}

TEST(RealData, the_abdomen_has_the_documented_lattice_and_tissue_means) {
  BODKIN_REQUIRE_DATA(data);
  const CtImage image = read_ct(data / "abdomen/abdomen_ct.nii.gz");
  EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{122, 101, 112}));
  EXPECT_EQ(image.ct.grid.spacing, Vec3(3, 3, 3));
  EXPECT_EQ(image.ct.grid.axes(), "RAS");
  EXPECT_EQ(range_of(image.ct), std::make_pair(-1024, 3382));  // -1207 is padding
  ASSERT_EQ(image.notes.size(), 1U);
  EXPECT_THAT(image.notes[0], HasSubstr("below -1024 HU"));
  const LabelVolume labels = labels_on(image.ct, data / "abdomen/abdomen_labels.nii.gz");
  EXPECT_NEAR(mean_where(image.ct, labels, 5), 45.0, 1.0);    // liver
  EXPECT_NEAR(mean_where(image.ct, labels, 1), 33.0, 1.0);    // spleen
  EXPECT_NEAR(mean_where(image.ct, labels, 29), 220.0, 1.0);  // L3
  EXPECT_NEAR(mean_where(image.ct, labels, 79), 4.0, 1.0);    // canal
}

TEST(RealData, a_dicom_series_and_the_same_volume_as_nifti_agree_voxel_by_voxel) {
  BODKIN_REQUIRE_DATA(data);
  const CtImage dicom = read_ct(data / "dicom_ct_lumbosacral/series");
  const CtImage nifti = read_ct(data / "dicom_ct_lumbosacral/same_volume_ct.nii.gz");
  EXPECT_EQ(dicom.ct.grid.size, (std::array<int, 3>{172, 160, 55}));
  EXPECT_EQ(dicom.ct.voxels, nifti.ct.voxels);
  EXPECT_TRUE(same_lattice(dicom.ct.grid, nifti.ct.grid, 1e-3));
  EXPECT_FALSE(dicom.resampled);
  EXPECT_NEAR((dicom.ct.grid.origin - Vec3(2.929558, 31.249856, -676.47)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(dicom.ct.grid.spacing.z(), 3.27, 1e-6);
  EXPECT_EQ(range_of(dicom.ct), std::make_pair(-1000, 1287));
  EXPECT_TRUE(dicom.notes.empty());

  const LabelVolume mass = labels_on(dicom.ct, data / "dicom_ct_lumbosacral/mass_mask.nii.gz");
  EXPECT_EQ(std::count(mass.voxels.begin(), mass.voxels.end(), 1), 37372);
  EXPECT_NEAR(mean_where(dicom.ct, mass, 1), 24.0, 1.0);
}

TEST(RealData, a_folder_with_a_structure_set_and_a_nifti_beside_the_series_reads_the_series) {
  BODKIN_REQUIRE_DATA(data);
  EXPECT_EQ(read_ct(data / "dicom_ct_lumbosacral").ct.voxels,
            read_ct(data / "dicom_ct_lumbosacral/series").ct.voxels);
}

TEST(RealData, axes_stored_p_i_r_are_carried_as_they_are) {
  BODKIN_REQUIRE_DATA(data);
  const CtVolume ct = read_ct(data / "lumbar_l3/lumbar_l3_ct.nii.gz").ct;
  EXPECT_EQ(ct.grid.axes(), "PIR");
  EXPECT_EQ(ct.grid.size, (std::array<int, 3>{73, 47, 73}));
  const Vec3 first = ct.grid.to_patient(Vec3::Zero()), last = ct.grid.to_patient(Vec3(72, 46, 72));
  EXPECT_LT((first.cwiseMin(last) - Vec3(-30, 135, -103.2)).norm(), 0.1);
  EXPECT_LT((first.cwiseMax(last) - Vec3(78, 243, -34.2)).norm(), 0.1);
  const LabelVolume parts = labels_on(ct, data / "lumbar_l3/lumbar_l3_subregions.nii.gz");
  EXPECT_NEAR(mean_where(ct, parts, 50), 54.0, 2.0);   // inside of the bodies
  EXPECT_NEAR(mean_where(ct, parts, 49), 256.0, 2.0);  // their shells
  EXPECT_NEAR(mean_where(ct, parts, 41), 491.0, 2.0);  // arches
}

TEST(RealData, labels_with_a_flipped_axis_are_placed_by_where_they_lie) {
  BODKIN_REQUIRE_DATA(data);
  const CtImage image = read_ct(data / "dicom_ct_thoracolumbar_j2k/series");
  EXPECT_EQ(image.ct.grid.axes(), "LPS");
  EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{512, 512, 20}));
  EXPECT_EQ(range_of(image.ct), std::make_pair(-1024, 1839));
  const LabelVolume raw = read_labels(data / "dicom_ct_thoracolumbar_j2k/labels.nii.gz");
  EXPECT_EQ(raw.grid.axes(), "LAS");
  const LabelVolume labels = labels_on(image.ct, data / "dicom_ct_thoracolumbar_j2k/labels.nii.gz");
  EXPECT_NEAR(mean_where(image.ct, labels, 52), 177.0, 1.0);  // aorta, contrast
  EXPECT_EQ(std::count(labels.voxels.begin(), labels.voxels.end(), 52),
            std::count(raw.voxels.begin(), raw.voxels.end(), 52));
}

TEST(RealData, three_slices_feet_first_line_up_with_their_nrrd_labels) {
  BODKIN_REQUIRE_DATA(data);
  const CtImage image = read_ct(data / "dicom_3slice_nrrd_labels/series");
  EXPECT_EQ(image.ct.grid.size, (std::array<int, 3>{512, 512, 3}));
  EXPECT_EQ(range_of(image.ct), std::make_pair(-1024, 1381));
  EXPECT_THAT(image.notes, testing::Contains(HasSubstr("below -1024 HU")));
  const LabelVolume both = labels_on(image.ct, data / "dicom_3slice_nrrd_labels/liver_spine_seg.nrrd");
  EXPECT_GT(mean_where(image.ct, both, 1), 20.0);  // liver
  EXPECT_LT(mean_where(image.ct, both, 1), 160.0);
  EXPECT_GT(mean_where(image.ct, both, 2), mean_where(image.ct, both, 1));  // the spine is denser
  const LabelVolume heart = labels_on(image.ct, data / "dicom_3slice_nrrd_labels/heart_seg.nrrd");
  EXPECT_GT(share_where(image.ct, heart, 3, -200, 300), 0.85);  // blood, muscle and some fat; the lungs lie around it
}

TEST(RealData, the_lung_mask_lies_on_lung) {
  BODKIN_REQUIRE_DATA(data);
  const CtVolume ct = read_ct(data / "lung_mha/lung_ct.mha").ct;
  EXPECT_EQ(ct.grid.size, (std::array<int, 3>{115, 157, 129}));
  EXPECT_LT((ct.grid.origin - Vec3(-153.827, -150.352, -1434.5)).norm(), 1e-9);
  const LabelVolume mask = labels_on(ct, data / "lung_mha/lung_mask.mha");
  EXPECT_LT(mean_where(ct, mask, 1), -600.0);
  EXPECT_EQ(read_ct(data / "lung_mha/lung_ct_small.mha").ct.grid.size, (std::array<int, 3>{57, 78, 64}));
}

TEST(RealData, a_tilted_gantry_is_resampled_with_a_note_and_keeps_its_hounsfield) {
  BODKIN_REQUIRE_DATA(data);
  const CtImage image = read_ct(data / "dicom_gantry_tilt_phantom/series");
  EXPECT_TRUE(image.resampled);
  EXPECT_THAT(image.notes, testing::Contains(HasSubstr("18.5 degrees")));
  EXPECT_NEAR(image.ct.grid.spacing.z(), 2.5 * std::cos(18.5 * 3.14159265 / 180.0), 1e-3);
  // The x axis is not tilted, so nothing moves along it; the stack is longer along y by what the slices drift.
  EXPECT_EQ(image.ct.grid.size[0], 512);
  EXPECT_EQ(image.ct.grid.size[2], 16);
  EXPECT_NEAR(image.ct.grid.size[1], 512 + 15 * 2.5 * std::sin(18.5 * 3.14159265 / 180.0) / 0.482421875, 1.5);
  EXPECT_GE(range_of(image.ct).first, -1024);
  EXPECT_LE(range_of(image.ct).second, 791);
  // A single slice and the same slice in the resampled volume show the same HU at the same place in the patient.
  const CtVolume slice = read_ct(data / "dicom_gantry_tilt_phantom/series/I280").ct;
  double worst = 0.0;
  int inside = 0;
  for (int j = 100; j < 412; j += 7) {
    for (int i = 100; i < 412; i += 7) {
      const Vec3 place = slice.grid.to_patient(Vec3(i, j, 0));
      const double around = slice.at(i, j - 1, 0) - slice.at(i, j + 1, 0);
      if (std::abs(around) > 40.0) continue;  // an edge, where interpolation between pixels shows
      worst = std::max(worst, std::abs(linear(image.ct, place, 0.0) - slice.at(i, j, 0)));
      ++inside;
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_LT(worst, 45.0);
}

TEST(RealData, eight_bit_grey_values_are_refused_as_not_hounsfield) {
  BODKIN_REQUIRE_DATA(data);
  const std::filesystem::path file = data / "oblique/head_phantom_ct_pitched.nii.gz";
  const CtImage image = read_ct(file);
  EXPECT_NEAR(image.ct.grid.spacing.z(), 2.397, 1e-3);
  const Vec3 k = image.ct.grid.direction.col(2);
  EXPECT_NEAR(std::atan2(std::abs(k.y()), k.z()) * 180.0 / 3.14159265, 16.5, 0.1);
  EXPECT_THAT(sentence_of([&] { require_hounsfield(image.ct, file.string()); }), HasSubstr("are not HU"));
}

TEST(RealData, odd_stacks_are_resampled_or_refused) {
  BODKIN_REQUIRE_DATA(data);
  const CtImage tilted = read_ct(data / "dicom_odd/gantry_tilt_4_slices");
  EXPECT_TRUE(tilted.resampled);
  EXPECT_THAT(tilted.notes, testing::Contains(HasSubstr("14.0 degrees")));
  const std::filesystem::path missing = data / "dicom_odd/missing_slice_4_slices";
  const std::string sentence = sentence_of([&] { read_ct(missing); });
  EXPECT_THAT(sentence, HasSubstr("a slice is missing between z ="));
  EXPECT_THAT(sentence, HasSubstr("10 mm instead of 5 mm"));
  DicomOptions fill;
  fill.fill_missing = true;
  const CtImage filled = read_ct(missing, fill);
  EXPECT_EQ(filled.ct.grid.size[2], 5);
  EXPECT_THAT(filled.notes, testing::Contains(HasSubstr("interpolated")));
  EXPECT_THAT(sentence_of([&] { read_ct(data / "dicom_odd"); }), HasSubstr("--series N"));
}

TEST(RealData, six_transfer_syntaxes_decode_to_the_same_pixels) {
  BODKIN_REQUIRE_DATA(data);
  const std::filesystem::path folder = data / "dicom_codecs";
  const CtVolume reference = read_ct(folder / "ct_slice_explicit_vr_le.dcm").ct;
  ASSERT_EQ(reference.voxels.size(), 512U * 512U);
  EXPECT_EQ(range_of(reference), std::make_pair(-1024, 1378));  // stored 2402, intercept -1024
  for (const char* name : {"ct_slice_implicit_vr_le.dcm", "ct_slice_rle.dcm", "ct_slice_jpeg_lossless_sv1.dcm",
                           "ct_slice_jpeg2000_lossless.dcm", "ct_slice_jpegls_lossless.dcm"}) {
    EXPECT_EQ(read_ct(folder / name).ct.voxels, reference.voxels) << name;
  }
}

TEST(RealData, one_crop_in_three_formats_is_one_volume_to_the_bit) {
  BODKIN_REQUIRE_DATA(data);
  const std::filesystem::path folder = data / "derived_same_crop_three_formats";
  const CtVolume nifti = read_ct(folder / "lumbar_crop_ct.nii.gz").ct;
  const LabelVolume nifti_labels = read_labels(folder / "lumbar_crop_labels.nii.gz");
  for (const std::string extension : {".nrrd", ".mha"}) {
    const CtVolume ct = read_ct(folder / ("lumbar_crop_ct" + extension)).ct;
    const LabelVolume labels = read_labels(folder / ("lumbar_crop_labels" + extension));
    EXPECT_EQ(ct.voxels, nifti.voxels);
    EXPECT_EQ(labels.voxels, nifti_labels.voxels);
    EXPECT_EQ(ct.grid.size, nifti.grid.size);
    EXPECT_EQ(ct.grid.spacing, nifti.grid.spacing);
    EXPECT_EQ(ct.grid.direction, nifti.grid.direction);
    EXPECT_EQ(ct.grid.origin, nifti.grid.origin);
    EXPECT_EQ(labels.grid.origin, nifti.grid.origin);
  }
}

TEST(RealData, labels_of_another_patient_are_refused_with_both_lattices) {
  BODKIN_REQUIRE_DATA(data);
  const CtVolume ct = read_ct(data / "lumbar_l3/lumbar_l3_ct.nii.gz").ct;
  const std::string sentence = sentence_of([&] { labels_on(ct, data / "abdomen/abdomen_labels.nii.gz"); });
  EXPECT_THAT(sentence, HasSubstr("do not lie on the CT's voxels"));
  EXPECT_THAT(sentence, HasSubstr("122 x 101 x 112 voxels of 3 x 3 x 3 mm"));
  EXPECT_THAT(sentence, HasSubstr("73 x 47 x 73 voxels of 1.5 x 1.5 x 1.5 mm"));
}

TEST(RealData, labels_of_the_whole_fit_a_crop_of_the_ct) {
  BODKIN_REQUIRE_DATA(data);
  const CtVolume crop = read_ct(data / "derived_same_crop_three_formats/lumbar_crop_ct.nrrd").ct;
  const LabelPlacement placed =
      place_labels(read_labels(data / "abdomen/abdomen_labels.nii.gz"), crop.grid, false, "labels");
  EXPECT_EQ(placed.labels.voxels,
            read_labels(data / "derived_same_crop_three_formats/lumbar_crop_labels.nrrd").voxels);
  EXPECT_THAT(placed.notes, testing::ElementsAre(HasSubstr("outside the CT")));
}

}  // namespace
}  // namespace bodkin
