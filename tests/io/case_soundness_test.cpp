// A small patient in memory: a block of fat under a millimetre of skin, with dura 30 mm deep.
#include "io/case_soundness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int edge = 40;  // voxels of 2 mm

// Air up to y = 20 mm, skin to 22, fat to 50, dura beyond; the needle goes along +y.
Case small_patient() {
  Grid grid;
  grid.size = {edge, edge, edge};
  grid.spacing = Vec3(2.0, 2.0, 2.0);
  grid.origin = Vec3(1.0, 1.0, 1.0);  // so that the box begins at 0
  Case patient;
  patient.library = default_tissue_library();
  patient.ct = CtVolume(grid, 0);
  patient.structures = LabelVolume(grid, 0);
  patient.tissues = TissueVolume(grid, tissue::fat);
  for (int k = 0; k < edge; ++k) {
    for (int j = 0; j < edge; ++j) {
      const TissueId id = j < 10 ? tissue::air : j < 11 ? tissue::skin : j < 25 ? tissue::fat : tissue::dura;
      for (int i = 0; i < edge; ++i) patient.tissues.at(i, j, k) = id;
    }
  }
  CaseDescription& description = patient.description;
  description.ct_file = "ct.nrrd";
  description.structures_file = "structures.nrrd";
  description.tissues_file = "tissues.nrrd";
  description.structures = {{7, "pancreas", "organ", true}};
  description.procedure.path = NeedlePath{Vec3(40.0, 20.0, 40.0), Vec3(40.0, 55.0, 40.0)};
  description.procedure.target_tissue = "dura";
  return patient;
}

TEST(CaseSoundness, a_sound_patient_has_no_problems) {
  Case patient = small_patient();
  patient.structures.at(3, 3, 3) = 7;
  EXPECT_THAT(lattice_problems(patient), IsEmpty());
  EXPECT_THAT(content_problems(patient), IsEmpty());
  patient.structures = {};
  patient.description.procedure.path.reset();
  EXPECT_THAT(content_problems(patient), IsEmpty());
}

TEST(CaseSoundness, structures_must_lie_on_the_lattice_of_the_ct) {
  Case patient = small_patient();
  patient.structures.grid.origin.z() += 0.5;
  EXPECT_THAT(lattice_problems(patient),
              ElementsAre(HasSubstr("structures.nrrd (40 x 40 x 40 voxels, axes LPS, from (1.0, 1.0, 1.5)) does "
                                    "not lie on the lattice of ct.nrrd")));
}

TEST(CaseSoundness, tissues_may_be_finer_but_must_cover_the_same_box) {
  Case patient = small_patient();
  Grid fine = patient.ct.grid;
  fine.size = {2 * edge, 2 * edge, 2 * edge};
  fine.spacing = Vec3::Ones();
  fine.origin = Vec3(0.5, 0.5, 0.5);
  patient.tissues = TissueVolume(fine, tissue::fat);
  EXPECT_THAT(lattice_problems(patient), IsEmpty());
  patient.tissues.grid.origin.x() = 1.0;  // as if the centres of the first voxels coincided
  EXPECT_THAT(lattice_problems(patient),
              ElementsAre("tissues.nrrd does not cover the same box as ct.nrrd: a corner lies 0.50 mm off"));
}

TEST(CaseSoundness, labels_and_tissue_ids_that_nothing_explains_are_named) {
  Case patient = small_patient();
  for (const int label : {9, 12}) patient.structures.at(label, 0, 0) = static_cast<std::uint16_t>(label);
  for (const int id : {40, 41, 42, 43, 44, 45, 46, 254})
    patient.tissues.at(id % edge, edge - 1, 0) = static_cast<TissueId>(id);
  EXPECT_THAT(
      content_problems(patient),
      ElementsAre("structures.nrrd has voxels with the labels 9 and 12, which case.xml does not list as a structure",
                  "tissues.nrrd has voxels with the tissue ids 40, 41, 42, 43, 44 and 3 more, which the tissue "
                  "library does not have"));
}

TEST(CaseSoundness, a_patient_of_air_is_none) {
  Case patient = small_patient();
  patient.tissues.voxels.assign(patient.tissues.voxels.size(), tissue::air);
  EXPECT_THAT(content_problems(patient), ElementsAre("tissues.nrrd holds nothing but air",
                                                     HasSubstr("it misses the body"), HasSubstr("does not meet")));
}

TEST(CaseSoundness, a_planned_path_begins_on_the_skin) {
  Case patient = small_patient();
  Vec3& entry = patient.description.procedure.path->entry;
  entry.y() = 17.5;
  EXPECT_THAT(content_problems(patient), IsEmpty()) << "half a voxel of doubt is allowed";
  entry.y() = 10.0;
  EXPECT_THAT(
      content_problems(patient),
      ElementsAre(
          "the entry (40.0, 10.0, 40.0) of the planned path lies 10.0 mm in front of the skin, expected on it"));
  entry.y() = 30.0;
  EXPECT_THAT(content_problems(patient), ElementsAre(HasSubstr("under the skin, expected on it")));
  // A crop may have no skin on the path.
  for (TissueId& id : patient.tissues.voxels) id = id == tissue::air ? tissue::fat : id;
  EXPECT_THAT(content_problems(patient), IsEmpty());
}

TEST(CaseSoundness, a_planned_path_stays_in_the_image_and_meets_its_aim) {
  Case patient = small_patient();
  NeedlePath& path = *patient.description.procedure.path;
  path.target = Vec3(40.0, 81.0, 40.0);
  EXPECT_THAT(content_problems(patient),
              ElementsAre("the target (40.0, 81.0, 40.0) of the planned path lies outside the image"));
  path.target = Vec3(40.0, 40.0, 40.0);
  EXPECT_THAT(content_problems(patient),
              ElementsAre("the planned path does not meet the target_tissue 'dura' within the "
                          "target_tolerance_mm of 3 after its target"));
  path.target = Vec3(40.0, 48.0, 40.0);
  EXPECT_THAT(content_problems(patient), IsEmpty()) << "within the tolerance";
}

TEST(CaseSoundness, a_planned_path_stays_out_of_the_spinal_cord) {
  Case patient = small_patient();
  for (int k = 0; k < edge; ++k) {
    for (int i = 0; i < edge; ++i) patient.tissues.at(i, 26, k) = tissue::spinal_cord;
  }
  EXPECT_THAT(content_problems(patient),
              ElementsAre("the planned path goes into the spinal cord 32.0 mm from its entry; plan it below the "
                          "conus, at L2/L3 or lower"));
  for (TissueId& id : patient.tissues.voxels) id = id == tissue::spinal_cord ? tissue::nerve : id;
  EXPECT_THAT(content_problems(patient), IsEmpty()) << "roots may be touched";
}

TEST(CaseSoundness, a_planned_path_is_no_longer_than_the_needle) {
  Case patient = small_patient();
  patient.description.needle.length = 30.0;
  EXPECT_THAT(content_problems(patient),
              ElementsAre("the planned path is 35.0 mm long, but the needle length_mm is 30; take a longer "
                          "needle or a nearer target"));
}

}  // namespace
}  // namespace bodkin
