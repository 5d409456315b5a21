#include "patient/from_ct/label_plausibility.h"

#include <array>
#include <map>

#include "patient/synthetic/lumbar.h"
#include "tests/io/images/test_images.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/images/image_source.h"
#include "io/images/label_placement.h"
#include "io/label_scheme.h"
#include "io/tissue_library_file.h"

// Labels that contradict their table: of another numbering, shifted against the CT, or unlike their names.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const SyntheticPatient& labelled_patient() {
  static const SyntheticPatient patient = [] {
    LumbarParameters parameters;
    parameters.spacing = 3.0;
    return synthesize_lumbar(parameters, default_tissue_library());
  }();
  return patient;
}

std::string refusal_of(const LabelVolume& labels, const std::vector<Structure>& table) {
  return test::sentence_of([&] { check_labels(labelled_patient().ct, labels, table); });
}

// The labels moved by whole voxels.
LabelVolume moved(const LabelVolume& labels, int di, int dj, int dk) {
  LabelVolume out(labels.grid);
  const auto& size = labels.grid.size;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (labels.grid.contains(i - di, j - dj, k - dk)) out.at(i, j, k) = labels.at(i - di, j - dj, k - dk);
      }
    }
  }
  return out;
}

TEST(LabelPlausibility, labels_that_fit_their_names_pass_without_a_word) {
  const SyntheticPatient& patient = labelled_patient();
  EXPECT_THAT(check_labels(patient.ct, patient.structures, patient.structure_table), IsEmpty());
}

TEST(LabelPlausibility, shifted_labels_are_refused_with_the_move_that_mends_them) {
  const SyntheticPatient& patient = labelled_patient();
  EXPECT_THAT(refusal_of(moved(patient.structures, 0, 0, 5), patient.structure_table),
              HasSubstr("moved by (0, 0, -15) mm (LPS)"));
  EXPECT_THAT(refusal_of(moved(patient.structures, 8, 0, 0), patient.structure_table),
              HasSubstr("moved by (-24, 0, 0) mm (LPS)"));
}

TEST(LabelPlausibility, the_older_numbers_of_totalsegmentator_are_recognised) {
  const SyntheticPatient& patient = labelled_patient();
  std::map<std::string, std::uint16_t> older;
  for (const Structure& entry : read_label_scheme("totalsegmentator_v1")) older[entry.name] = entry.label;
  std::map<std::uint16_t, std::uint16_t> renumbered;
  for (const Structure& entry : patient.structure_table) {
    const auto found = older.find(entry.name);
    renumbered[entry.label] = found == older.end() ? std::uint16_t{0} : found->second;
  }
  LabelVolume labels = patient.structures;
  for (std::uint16_t& label : labels.voxels) label = label == 0 ? std::uint16_t{0} : renumbered[label];
  EXPECT_THAT(refusal_of(labels, read_label_scheme("totalsegmentator")),
              HasSubstr("these look like TotalSegmentator v1 numbers: use --scheme totalsegmentator_v1"));
  EXPECT_NO_THROW(check_labels(patient.ct, labels, read_label_scheme("totalsegmentator_v1")));
}

TEST(LabelPlausibility, a_single_structure_unlike_its_name_gets_a_note) {
  const SyntheticPatient& patient = labelled_patient();
  std::vector<Structure> table = patient.structure_table;
  for (Structure& entry : table) {
    if (entry.tissue == "muscle") entry = {entry.label, "left_lung", "lung", true};
  }
  const auto notes = check_labels(patient.ct, patient.structures, table);
  ASSERT_FALSE(notes.empty());
  EXPECT_THAT(notes.front(), HasSubstr("(left_lung) is unlike its name"));
  EXPECT_THAT(notes.front(), HasSubstr("expected below -250 for lung"));
}

TEST(LabelPlausibility, the_labels_of_the_real_cts_pass) {
  BODKIN_REQUIRE_DATA(data);
  const std::vector<std::array<const char*, 3>> sets = {
      {"abdomen/abdomen_ct.nii.gz", "abdomen/abdomen_labels.nii.gz", "totalsegmentator"},
      {"abdomen/abdomen_ct.nii.gz", "abdomen/abdomen_vertebrae.nii.gz", "totalsegmentator"},
      {"lumbar_l3/lumbar_l3_ct.nii.gz", "lumbar_l3/lumbar_l3_vertebrae.nii.gz", "tptbox"},
      {"lumbar_l3/lumbar_l3_ct.nii.gz", "lumbar_l3/lumbar_l3_subregions.nii.gz", "tptbox"},
      {"dicom_ct_thoracolumbar_j2k/series", "dicom_ct_thoracolumbar_j2k/labels.nii.gz", "totalsegmentator"}};
  for (const auto& [ct_file, label_file, scheme] : sets) {
    SCOPED_TRACE(label_file);
    const CtVolume ct = read_ct(data / ct_file).ct;
    const LabelVolume labels = place_labels(read_labels(data / label_file), ct.grid, false, label_file).labels;
    EXPECT_THAT(check_labels(ct, labels, read_label_scheme(scheme)), IsEmpty());
  }
}

}  // namespace
}  // namespace bodkin
